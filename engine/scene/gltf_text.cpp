#include "engine/scene/gltf_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>

namespace scene {

namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// Deeper nesting than any glTF property asks for; the parser's own recursion stays small.
constexpr int kMaxDepth = 64;

std::uint32_t little_endian(std::span<const std::uint8_t> bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U
           | static_cast<std::uint32_t>(bytes[at + 2]) << 16U
           | static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

/// Properties whose numbers are indices, offsets, lengths, counts or enumerators.
constexpr std::array kWholeNumbers = std::to_array<std::string_view>({
    "buffer",   "bufferView",    "byteLength", "byteOffset", "byteStride", "camera",
    "children", "componentType", "count",      "indices",    "input",      "inverseBindMatrices",
    "joints",   "magFilter",     "material",   "mesh",       "minFilter",  "mode",
    "node",     "nodes",         "output",     "sampler",    "scene",      "skeleton",
    "skin",     "source",        "target",     "texCoord",   "wrapS",      "wrapT",
});
static_assert(std::is_sorted(kWholeNumbers.begin(), kWholeNumbers.end()));

/// Walks the JSON once and keeps nothing but where it is.
class TextCheck : public nlohmann::json_sax<nlohmann::json> {
public:
    std::string message; ///< why the walk ended early

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }

    bool number_integer(number_integer_t value) override {
        return !whole()
               || refuse(fmt::format("'{}' is {}, expected a number from 0 up", key_, value));
    }
    bool number_unsigned(number_unsigned_t value) override {
        constexpr number_unsigned_t kLargest = std::numeric_limits<std::int32_t>::max();
        return !whole() || value <= kLargest
               || refuse(fmt::format("'{}' is {}, expected at most {}", key_, value, kLargest));
    }
    bool number_float(number_float_t value, const string_t& /*text*/) override {
        return !whole() || refuse(fmt::format("'{}' is {}, expected a whole number", key_, value));
    }

    bool start_object(std::size_t /*size*/) override { return enter(); }
    bool start_array(std::size_t /*size*/) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool key(string_t& value) override {
        key_ = value;
        if (free_depth_ == depth_) free_depth_ = 0;
        if (free_depth_ == 0 && (value == "extras" || value == "extensions")) free_depth_ = depth_;
        return true;
    }
    bool parse_error(
        std::size_t /*position*/,
        const std::string& /*token*/,
        const nlohmann::json::exception& error) override {
        return refuse(fmt::format("not readable as JSON: {}", error.what()));
    }

private:
    /// Inside extras and extensions names mean what their authors like.
    [[nodiscard]] bool whole() const {
        return free_depth_ == 0
               && std::binary_search(kWholeNumbers.begin(), kWholeNumbers.end(), key_);
    }
    bool refuse(std::string sentence) {
        message = std::move(sentence);
        return false;
    }
    bool enter() {
        ++depth_;
        return depth_ <= kMaxDepth
               || refuse(fmt::format("nested deeper than {} levels", kMaxDepth));
    }
    bool leave() {
        --depth_;
        if (depth_ < free_depth_) free_depth_ = 0;
        return true;
    }

    int depth_ = 0;
    int free_depth_ =
        0; ///< depth of the object that holds the extras or extensions we are in; 0 outside
    std::string key_;
};

} // namespace

bool is_binary_gltf(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

engine::Result<std::string_view> gltf_text(std::span<const std::uint8_t> bytes) {
    const auto text = [&](std::size_t first, std::size_t count) {
        return std::string_view(reinterpret_cast<const char*>(bytes.data()) + first, count);
    };
    if (!is_binary_gltf(bytes)) return text(0, bytes.size());

    constexpr std::size_t kFirstByte = kHeaderBytes + kChunkHeaderBytes;
    if (bytes.size() < kFirstByte)
        return engine::Error{"a binary glTF file shorter than its header"};
    const std::uint32_t version = little_endian(bytes, 4);
    if (version != 2)
        return engine::Error{fmt::format("binary glTF version {}, expected 2", version)};
    const std::uint64_t length = little_endian(bytes, 8);
    if (length > bytes.size())
        return engine::Error{
            fmt::format("its header says {} bytes, but the file has {}", length, bytes.size())};
    const std::uint64_t json_length = little_endian(bytes, kHeaderBytes);
    if (little_endian(bytes, kHeaderBytes + 4) != kJsonChunk)
        return engine::Error{"its first chunk is not JSON"};
    if (kFirstByte + json_length > length)
        return engine::Error{
            fmt::format("its JSON chunk of {} bytes reaches past the end", json_length)};

    const std::uint64_t binary_at = kFirstByte + json_length;
    if (binary_at < length) {
        if (binary_at + kChunkHeaderBytes > length)
            return engine::Error{"its second chunk has no header"};
        const std::uint64_t binary_length = little_endian(bytes, binary_at);
        if (little_endian(bytes, binary_at + 4) != kBinaryChunk)
            return engine::Error{"its second chunk is not BIN"};
        if (binary_at + kChunkHeaderBytes + binary_length > length)
            return engine::Error{
                fmt::format("its BIN chunk of {} bytes reaches past the end", binary_length)};
    }
    return text(kFirstByte, json_length);
}

engine::Result<void> check_gltf_text(std::string_view json) {
    TextCheck check;
    if (!nlohmann::json::sax_parse(json.begin(), json.end(), &check))
        return engine::Error{check.message};
    return {};
}

} // namespace scene
