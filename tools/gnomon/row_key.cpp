#include "tools/gnomon/row_key.hpp"

#include <embedded/gpu_shaders.hpp>
#include <embedded/render_shaders.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <set>
#include <sstream>

namespace gnomon {

namespace {

namespace fs = std::filesystem;

/// Raised whenever rows mean something else than before.
constexpr int kFormat = 1;

/// Source: Fowler, Noll and Vo, "FNV Hash" (1a, 64 bits).
void digest_bytes(const std::string& bytes, std::uint64_t& digest) {
    for (const char byte : bytes) {
        digest ^= static_cast<unsigned char>(byte);
        digest *= 0x100000001B3U;
    }
}

std::optional<std::string> read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    std::stringstream buffer;
    buffer << stream.rdbuf();
    return buffer.str();
}

/// Texts between quotes that could be names of files.
std::set<std::string> quoted_names(const std::string& text) {
    constexpr std::size_t kLongest = 200;
    std::set<std::string> names;
    for (const char quote : {'"', '\''})
        for (std::size_t begin = text.find(quote); begin != std::string::npos;) {
            const std::size_t end = text.find_first_of(std::string("\n") + quote, begin + 1);
            if (end == std::string::npos) break;
            const std::size_t length = end - begin - 1;
            if (text[end] == quote && length > 0 && length < kLongest)
                names.insert(text.substr(begin + 1, length));
            // A closing quote may be the next one's opening: apostrophes stand alone.
            begin = text[end] == quote ? end : text.find(quote, end);
        }
    return names;
}

/// Files of a scene, each once.
void collect(const fs::path& file, const fs::path& root, std::set<fs::path>& files) {
    std::error_code problem;
    const fs::path whole = fs::weakly_canonical(file, problem);
    if (problem || !fs::is_regular_file(whole, problem) || !files.insert(whole).second) return;
    const std::string kind = whole.extension().string();
    if (kind != ".lua" && kind != ".gltf") return;
    const auto text = read(whole);
    if (!text) return;
    for (const std::string& name : quoted_names(*text))
        for (const fs::path& folder : {whole.parent_path(), root})
            for (const char* ending : {"", ".lua", ".glb"})
                collect(folder / (name + ending), root, files);
}

std::int64_t ticks(fs::file_time_type time) {
    return static_cast<std::int64_t>(time.time_since_epoch().count());
}

} // namespace

engine::Result<std::string> scene_digest(const fs::path& file) {
    std::set<fs::path> files;
    collect(file, file.parent_path(), files);
    if (files.empty())
        return engine::Error{"cannot be read; expected a scene's file", {file.string()}};
    std::uint64_t digest = 0xCBF29CE484222325U;
    for (const fs::path& part : files) {
        digest_bytes(part.filename().string(), digest);
        digest_bytes(read(part).value_or(""), digest);
    }
    return fmt::format("{:016x}", digest);
}

std::string program_stamp() {
    std::error_code problem;
    std::int64_t newest =
        ticks(fs::last_write_time(fs::canonical("/proc/self/exe", problem), problem));
    std::vector<gpu::ShaderFolder> folders = shadows::shader_folders();
    folders.push_back(embedded::render_shaders());
    folders.push_back(embedded::gpu_shaders());
    for (const gpu::ShaderFolder& folder : folders) {
        if (folder.disk_path.empty()) continue;
        for (const auto& entry : fs::recursive_directory_iterator(folder.disk_path, problem))
            newest = std::max(newest, ticks(entry.last_write_time(problem)));
    }
    return fmt::format("{:x}", newest);
}

engine::Result<nlohmann::json> level_key(
    const Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    const std::string& renderer) {
    const auto digest = scene_digest(level.file);
    if (!digest) return digest.error();
    nlohmann::json view = nlohmann::json::array();
    for (int i = 0; i < 3; ++i) {
        view.push_back(camera.position[i]);
        for (int j = 0; j < 3; ++j)
            view.push_back(camera.world_from_view[i][j]);
    }
    view.push_back(camera.fov_y);
    return nlohmann::json{
        {"format", kFormat},
        {"program", program_stamp()},
        {"renderer", renderer},
        {"scene", level.name},
        {"files", *digest},
        {"camera", camera.name},
        {"view", view},
        {"size", {camera.width, camera.height}},
        {"samples", options.truth_samples}};
}

nlohmann::json row_key(
    const nlohmann::json& level_key,
    const MeasureOptions& options,
    const std::string& light,
    const std::string& technique,
    const std::string& protocol) {
    nlohmann::json key = level_key;
    key["light"] = light;
    key["technique"] = technique;
    key["protocol"] = protocol;
    // What belongs to the other kind of rows does not change this one.
    if (protocol == measure::kStill)
        key["timed"] = {options.timing.frames, options.timing.warmup, options.timing.seconds};
    else
        key["frames"] = options.moving_frames;
    return key;
}

} // namespace gnomon
