#include "tests/engine/scene/gltf_document.hpp"

#include "engine/scene/gltf.hpp"

#include <gtest/gtest.h>

namespace testing_gltf {

namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? kDigits[group >> (18U - 6U * k) & 63U] : '=';
    }
    return text;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

} // namespace

int Document::add(const char* array, const nlohmann::json& value) {
    json[array].push_back(value);
    return static_cast<int>(json[array].size()) - 1;
}

int Document::view(const void* bytes, std::size_t count) {
    const std::size_t offset = buffer.size();
    buffer.resize(offset + (count + 3) / 4 * 4);
    std::memcpy(buffer.data() + offset, bytes, count);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", count}});
}

std::string Document::text() const {
    nlohmann::json whole = json;
    if (!buffer.empty())
        whole["buffers"] = {
            {{"byteLength", buffer.size()},
             {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    return whole.dump();
}

std::vector<std::uint8_t> Document::binary() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::uint8_t> bytes = {'g', 'l', 'T', 'F'};
    append(bytes, 2);
    append(bytes, static_cast<std::uint32_t>(28 + text.size() + buffer.size()));
    append(bytes, static_cast<std::uint32_t>(text.size()));
    append(bytes, 0x4E4F534A);
    bytes.insert(bytes.end(), text.begin(), text.end());
    append(bytes, static_cast<std::uint32_t>(buffer.size()));
    append(bytes, 0x004E4942);
    bytes.insert(bytes.end(), buffer.begin(), buffer.end());
    return bytes;
}

engine::Result<scene::Model> Document::load() const {
    const std::string whole = text();
    return scene::load_gltf_bytes(
        {reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()}, "test.gltf");
}

Document triangle() {
    Document document;
    document.accessor<float>("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    document.accessor<float>("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    document.accessor<std::uint16_t>("SCALAR", 1, {0, 1, 2});
    document.add(
        "meshes",
        {{"name", "Box"},
         {"primitives", {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}}}}});
    document.add("nodes", {{"name", "node"}, {"mesh", 0}});
    document.add("scenes", {{"nodes", {0}}});
    document.json["scene"] = 0;
    return document;
}

scene::Model loaded(const Document& document) {
    auto model = document.load();
    if (model) return std::move(*model);
    ADD_FAILURE() << engine::to_string(model.error());
    return {};
}

} // namespace testing_gltf
