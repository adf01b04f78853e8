// Whether a caster's shadow can reach the camera's near plane: then counting from the eye starts in
// the middle of a volume, or the near plane cuts one open, and counts must start from infinity.

#pragma once

#include "systems/shadows/shadow_scene.hpp"

#include <array>

namespace shadows {

/// The near rectangle's corners, relative to the camera's position, in the order of its rim.
std::array<glm::dvec3, 4> near_rectangle(const scene::CameraView& camera);

/// False only when no point of the box lies between the light and the near rectangle: inside the
/// pyramid from a lamp over the rectangle, or the prism from the rectangle toward a sun.
/// Cost: 13 planes.
/// Source: the near-clip volume of C. Everitt and M. Kilgard, "Practical and Robust Stenciled
/// Shadow Volumes for Hardware-Accelerated Rendering", 2002.
bool may_shade_near_plane(
    const scene::CameraView& camera, const LightView& light, const engine::WorldAabb& caster);

} // namespace shadows
