// How many of a caster's volumes hold the camera's near rectangle: where all of it is in the same
// ones, counting from before may start there instead of starting from behind, and the caster's caps
// need not be drawn although it shades the eye.

#pragma once

#include "systems/shadows/shadow_scene.hpp"
#include "systems/shadows/volumes/shadow_volume.hpp"

#include <optional>
#include <span>

namespace shadows {

/// None when the rectangle may touch the caster, or an edge of its outline lies between rectangle
/// and light, so that a side of a volume cuts it.
/// @param positions of the mesh's vertices, as the volume was built from
/// @param light_mesh as VolumeBuilder has it
/// @param bounds of the caster, world space
/// Cost: about 20 ns for each edge of the outline and each triangle of the caps.
/// Source: a view ray's count at the near plane, S. Hornus et al., "ZP+: Correct Z-pass Stencil
/// Shadows", 2005, for the whole rectangle at once.
std::optional<int> start_count(
    const scene::CameraView& camera,
    const ShadowVolume& volume,
    std::span<const glm::vec3> positions,
    const glm::dmat4& world_from_mesh,
    const glm::dvec4& light_mesh,
    const engine::WorldAabb& bounds);

} // namespace shadows
