#include "tools/gnomon/render_files.hpp"

#include "engine/scene/views.hpp"
#include "systems/shadows/plan_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>

#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

using Json = nlohmann::ordered_json;

/// Source: Fowler, Noll and Vo, FNV-1a, 64 bits.
std::uint64_t hash_of(const engine::Image& image) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const std::uint8_t byte : image.bytes)
        hash = (hash ^ byte) * 0x100000001b3ULL;
    return hash;
}

/// Ids as colours: 8 bits in each of red, green and blue, lowest first.
engine::Image ids_image(const std::vector<std::uint32_t>& ids, int width, int height) {
    engine::Image image(width, height, 3);
    for (std::size_t i = 0; i < ids.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            image.bytes[3 * i + channel] = static_cast<std::uint8_t>(ids[i] >> (8 * channel));
    return image;
}

Json to_json(const FrameStatistics& frames) {
    return {{"median_ms", frames.median_ms}, {"min_ms", frames.min_ms}, {"p99_ms", frames.p99_ms}};
}

Json to_json(const gpu::Counters& counters) {
    return {
        {"draws", counters.draws},
        {"triangles", counters.triangles},
        {"map_texels", counters.map_texels},
        {"mask_fragments", counters.mask_fragments},
        {"stencil_fragments", counters.stencil_fragments},
        {"taps", counters.taps}};
}

std::string
stats_json(Studio& studio, const std::optional<FrameTimes>& times, int width, int height) {
    const gpu::Frame& frame = studio.renderer().frame();
    Json json;
    json["renderer"] = studio.device().renderer;
    json["size"] = {width, height};
    json["frames"] = times ? times->frames : 0;
    if (times) {
        json["with"] = to_json(times->with);
        json["without"] = to_json(times->without);
    }
    json["pass_timer"] = gpu::name(frame.timers().backend());
    json["passes"] = Json::array();
    if (times)
        for (const gpu::PassTime& pass : times->passes)
            json["passes"].push_back({{"name", pass.name}, {"ms", pass.ms}});
    json["counters"] = to_json(frame.counters());
    json["gpu_bytes"] = gpu::device_bytes();
    return json.dump(1) + "\n";
}

/// Writes pictures, and prints their hashes when asked.
class PictureWriter {
public:
    PictureWriter(std::filesystem::path folder, bool hash)
        : folder_(std::move(folder)),
          hash_(hash) {}

    engine::Result<void> write(const std::string& name, const engine::Image& image) const {
        if (hash_) fmt::print("hash {} {:016x}\n", name, hash_of(image));
        return engine::write_png(folder_ / name, image);
    }

private:
    std::filesystem::path folder_;
    bool hash_;
};

engine::Result<void> write_masks(Studio& studio, const PictureWriter& writer) {
    std::set<std::string> used;
    const auto& lights = studio.lights();
    for (std::size_t light = 0; light < lights.size(); ++light) {
        std::string word = file_word(lights[light].name);
        while (!used.insert(word).second)
            word += "_";
        const auto mask = studio.mask(light);
        if (!mask) return mask.error();
        if (auto written = writer.write("mask_" + word + ".png", *mask); !written) return written;
    }
    return {};
}

} // namespace

std::optional<std::string>
unsupported(Studio& studio, const Level& level, const ShadowOptions& options) {
    return missing_technique(
        options, scene::placed_lights(level.world), studio.shadows().techniques());
}

engine::Result<void> write_render_files(
    Studio& studio,
    const std::filesystem::path& folder,
    const std::optional<FrameTimes>& times,
    bool hash) {
    if (auto made = make_folder(folder); !made) return made;
    const engine::Image color = studio.color();
    const PictureWriter writer(folder, hash);
    // Statistics first: reading masks draws them again.
    const std::string stats = stats_json(studio, times, color.width, color.height);
    if (auto written = write_text(folder / "stats.json", stats); !written) return written;
    const auto& shadows = studio.shadows();
    if (auto written = write_text(
            folder / "plans.json", shadows::plans_to_json(shadows.scene(), shadows.plan()));
        !written)
        return written;
    if (auto written = writer.write("color.png", color); !written) return written;
    const engine::Image ids = ids_image(studio.receiver_ids(), color.width, color.height);
    if (auto written = writer.write("ids.png", ids); !written) return written;
    return write_masks(studio, writer);
}

} // namespace gnomon
