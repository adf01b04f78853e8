// How a shadow texture lies round its casters, as their light sees them. Pure arithmetic.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/maps/map_view.hpp"
#include "systems/shadows/remedies.hpp"
#include "systems/shadows/shadow_scene.hpp"

#include <span>
#include <variant>

namespace shadows {

/// A sun's rays are parallel, a lamp's come from a point.
using TextureView = std::variant<ParallelView, PyramidView>;

/// A texture that opens wider to each side than this would spend most texels on its rim.
inline constexpr double kWidestTexture = 1.2217304763960306; // 70 degrees

/// The least view that holds all casters, and a border round them. A spot's is no wider than its
/// cone.
/// @param casters bounds, at least one
/// @param behind bounds of what else is drawn behind them, or empty
/// @param size texels per side
/// @param border texels that stay empty on each side
/// Errors: casters round a lamp, or so close to it that no texture can hold them.
engine::Result<TextureView> fit_texture(
    const LightView& light,
    std::span<const engine::WorldAabb> casters,
    const engine::WorldAabb& behind,
    int size,
    int border,
    const Remedies& remedies = {});

glm::dmat4 map_from_world(const TextureView& view);

/// Whether a point lies where the texture has texels; nothing else can be dark.
bool holds(const TextureView& view, const glm::dvec3& point);

/// The whole texture's larger side where it passes a point, metres; 0 behind the lamp.
double side_at(const TextureView& view, const glm::dvec3& point);

} // namespace shadows
