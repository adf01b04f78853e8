#include "tools/gnomon/view_options.hpp"

#include "engine/core/text.hpp"
#include "systems/shadows/maps/cascade_fit.hpp"
#include "systems/shadows/planar_prediction.hpp"
#include "systems/shadows/technique_registry.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace gnomon {

namespace {

/// A technique that `map` stands for.
std::string map_technique(scene::LightKind kind) {
    switch (kind) {
    case scene::LightKind::spot:
        return "spot_map";
    case scene::LightKind::point:
        return "cube_map";
    case scene::LightKind::directional:
        break;
    }
    return "cascaded_map";
}

std::optional<int> whole_number(std::string_view text) {
    int value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                      : std::nullopt;
}

constexpr int kMostLightSamples = 4096;
constexpr int kLongestPeriod = 1000; // frames

/// "@16:boxes" of "planar@16:boxes"; either part may be missing.
engine::Result<ShadowOptions>
with_planar_settings(const std::string& word, std::string_view setting, ShadowOptions options) {
    const std::size_t colon = std::min(setting.find(':'), setting.size());
    if (colon < setting.size()) {
        const std::string way(setting.substr(colon + 1));
        const std::span<const std::string_view> ways = shadows::kPlanarWays;
        if (std::find(ways.begin(), ways.end(), way) == ways.end())
            return engine::Error{fmt::format(
                "--technique {}: '{}' is no way of planar; expected one of {}{}",
                word,
                way,
                fmt::join(ways, ", "),
                engine::did_you_mean(way, ways))};
        options.way = way;
    }
    setting = setting.substr(0, colon);
    if (setting.empty()) return options;
    options.samples = whole_number(setting.substr(1));
    if (options.samples && *options.samples >= 1 && *options.samples <= kMostLightSamples)
        return options;
    return engine::Error{fmt::format(
        "--technique {}: '{}' after '@' is no number of light samples; write planar@16 (1 to {})",
        word,
        setting.substr(1),
        kMostLightSamples)};
}

} // namespace

engine::Result<glm::ivec2> ViewOptions::size_px() const {
    constexpr int kMaxSide = 16384;
    const std::size_t cross = std::min(size.find('x'), size.size());
    const int width = whole_number(std::string_view(size).substr(0, cross)).value_or(0);
    const int height = cross == size.size()
                           ? 0
                           : whole_number(std::string_view(size).substr(cross + 1)).value_or(0);
    if (std::min(width, height) < 1 || std::max(width, height) > kMaxSide)
        return engine::Error{
            fmt::format("--size {}: expected WIDTHxHEIGHT, each from 1 to {}", size, kMaxSide)};
    return glm::ivec2(width, height);
}

scene::ShadowWish ShadowOptions::wish(scene::LightKind kind) const {
    scene::ShadowWish wish;
    if (technique == "map")
        wish.technique = map_technique(kind);
    else if (technique != "auto")
        wish.technique = technique;
    wish.map_size = map_size;
    wish.proxy = proxy;
    wish.cascades = cascades;
    wish.filter = filter;
    wish.samples = samples;
    wish.way = way;
    wish.refresh = period;
    wish.error_px = error_px;
    return wish;
}

void add_view_options(CLI::App& command, ViewOptions& options) {
    command.add_option("--size", options.size, "WIDTHxHEIGHT of the picture, pixels")
        ->capture_default_str();
    command.add_option(
        "--camera",
        options.camera,
        "name of a camera; else the first, else one that frames the scene");
}

void add_shadow_options(CLI::App& command, ShadowOptions& options) {
    command
        .add_option(
            "--technique",
            options.technique,
            "auto, map, or the name of a technique; map@1024, map@1024x2:pcf, volume@1 and "
            "auto@0.5 "
            "say more")
        ->capture_default_str();
    command.add_option("--map-size", options.map_size, "texels per side of shadow maps")
        ->check(CLI::Range(16, 16384));
    command.add_option("--cascades", options.cascades, "shadow maps of a directional light")
        ->check(CLI::Range(1, shadows::kMaxCascades));
    command.add_option("--filter", options.filter, "how maps are read")
        ->check(CLI::IsMember({"nearest", "bilinear", "pcf", "pcss"}));
    command.add_option("--samples", options.samples, "light samples of soft shadows")
        ->check(CLI::Range(1, kMostLightSamples));
    command
        .add_option("--error-px", options.error_px, "accepted error, pixels of edge displacement")
        ->check(CLI::Range(0.0, 1000.0));
    command
        .add_option("--shadow-ms", options.shadow_ms, "accepted predicted shadow work per frame")
        ->check(CLI::PositiveNumber);
    command
        .add_option(
            "--refresh",
            options.refresh,
            "always: redraw every job in every frame; auto: when needed")
        ->check(CLI::IsMember({"always", "auto"}))
        ->capture_default_str();
}

engine::Result<ShadowOptions> options_from_word(
    const std::string& whole_word, const shadows::Techniques& techniques, ShadowOptions others) {
    const std::size_t percent = std::min(whole_word.find('%'), whole_word.size());
    const std::string word = whole_word.substr(0, percent);
    if (percent < whole_word.size()) {
        others.period = whole_number(std::string_view(whole_word).substr(percent + 1));
        if (!others.period || *others.period < 1 || *others.period > kLongestPeriod)
            return engine::Error{fmt::format(
                "--technique {}: '{}' after '%' is no number of frames; write map@1024%4 (1 to {})",
                whole_word,
                whole_word.substr(percent + 1),
                kLongestPeriod)};
    }
    const std::string setting = word.substr(std::min(word.find_first_of("@:"), word.size()));
    ShadowOptions options = std::move(others);
    options.technique = word.substr(0, word.size() - setting.size());
    auto words = shadows::technique_words(techniques);
    words.emplace_back("map");
    if (std::find(words.begin(), words.end(), options.technique) == words.end())
        return engine::Error{fmt::format(
            "--technique {}: expected one of {}{}",
            options.technique,
            fmt::join(words, ", "),
            engine::did_you_mean(options.technique, words))};
    if (setting.empty()) return options;
    if (options.technique == "volume") {
        options.proxy = whole_number(std::string_view(setting).substr(1)).value_or(-1);
        if (*options.proxy < 0 || *options.proxy > static_cast<int>(scene::kProxyLevels))
            return engine::Error{fmt::format(
                "--technique {}: '{}' after '@' is no level of simplified casters; write volume@0 "
                "(the casters themselves) to volume@{}",
                word,
                setting.substr(1),
                scene::kProxyLevels)};
        return options;
    }
    if (options.technique == "planar") return with_planar_settings(word, setting, options);
    const std::size_t colon = std::min(setting.find(':'), setting.size());
    if (colon < setting.size()) options.filter = setting.substr(colon + 1);
    const std::string numbers = setting.substr(1, colon - 1);
    const bool is_auto = options.technique == "auto";
    const std::size_t cross =
        is_auto ? numbers.size() : std::min(numbers.find('x'), numbers.size());
    const auto size = whole_number(std::string_view(numbers).substr(0, cross));
    if (cross < numbers.size())
        options.cascades = whole_number(std::string_view(numbers).substr(cross + 1)).value_or(0);
    char* end = nullptr;
    const float error_px = std::strtof(numbers.c_str(), &end);
    const bool right =
        is_auto ? !numbers.empty() && *end == '\0' && error_px > 0.0F && error_px <= 1000.0F
                : size && *size >= 16 && *size <= 16384;
    const int cascades = options.cascades.value_or(1);
    if (!right || cascades < 1 || cascades > shadows::kMaxCascades)
        return engine::Error{fmt::format(
            "--technique {}: '{}' after '@' is no size or error; write map@1024, map@1024x2 "
            "(1 to {} cascades) or auto@0.5",
            word,
            numbers,
            shadows::kMaxCascades)};
    if (is_auto)
        options.error_px = error_px;
    else
        options.map_size = *size;
    return options;
}

void override_wishes(shadows::ShadowSettings& settings, const ShadowOptions& options) {
    for (const scene::LightKind kind :
         {scene::LightKind::directional, scene::LightKind::spot, scene::LightKind::point})
        settings.overriding[kind] = options.wish(kind);
}

std::optional<std::string> missing_technique(
    const ShadowOptions& options,
    std::span<const scene::PlacedLight> lights,
    const shadows::Techniques& techniques) {
    for (const scene::PlacedLight& light : lights) {
        const auto wanted = options.wish(light.light.kind).technique;
        if (wanted && shadows::find_technique(techniques, *wanted) == nullptr)
            return fmt::format(
                "technique '{}' does not exist yet (light '{}')", *wanted, light.name);
    }
    return std::nullopt;
}

} // namespace gnomon
