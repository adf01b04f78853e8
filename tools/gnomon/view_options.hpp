// Options that several subcommands share: what to look at, how large, and what is asked of shadows.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/description.hpp"
#include "engine/scene/light.hpp"
#include "systems/shadows/shadow_settings.hpp"
#include "systems/shadows/shadow_technique.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>

namespace CLI {
class App;
}

namespace gnomon {

struct ViewOptions {
    std::string size = "1280x720";
    std::string camera;
    /// @return width and height. Errors: not WIDTHxHEIGHT, or a side that is not 1 to 16384
    [[nodiscard]] engine::Result<glm::ivec2> size_px() const;
};

struct ShadowOptions {
    std::string technique = "auto"; ///< its name alone
    std::optional<int> map_size;
    std::optional<int> proxy;
    std::optional<int> cascades;
    std::optional<std::string> filter;
    std::optional<int> samples;
    std::optional<std::string> way;
    std::optional<int> period; ///< frames from one refresh to the next
    std::optional<float> error_px;
    std::optional<float> shadow_ms;
    std::string refresh = "auto";

    /// What overrides every other wish. "map" is the map technique of the light's kind.
    [[nodiscard]] scene::ShadowWish wish(scene::LightKind kind) const;
};

void add_view_options(CLI::App& command, ViewOptions& options);
void add_shadow_options(CLI::App& command, ShadowOptions& options);

/// A technique with its main settings in one word: "planar", "map@2048" (texels per side),
/// "map@2048x2" (and cascades), "cascaded_map@1024:pcf" (and the filter), "planar@16" (light
/// samples), "planar:boxes" (its way of doing it), "auto@0.5" (accepted error, pixels); "%4" at the
/// end of any of them: refreshed in every fourth frame. What the word does not say is taken from
/// `others`. Errors: a technique that does not exist, with the nearest one; a setting that is no
/// number.
engine::Result<ShadowOptions> options_from_word(
    const std::string& word, const shadows::Techniques& techniques, ShadowOptions others = {});

/// The wishes of the command line, on top of all others.
void override_wishes(shadows::ShadowSettings& settings, const ShadowOptions& options);

/// Why a technique cannot serve these lights at all in this build, or nothing.
std::optional<std::string> missing_technique(
    const ShadowOptions& options,
    std::span<const scene::PlacedLight> lights,
    const shadows::Techniques& techniques);

} // namespace gnomon
