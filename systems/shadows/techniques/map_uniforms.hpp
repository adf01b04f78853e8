// Tells a mask where the views of its map lie: the uniforms of include/map_inputs.glsl.

#pragma once

#include "engine/gpu/program.hpp"
#include "engine/scene/camera.hpp"
#include "systems/shadows/maps/map_view.hpp"

namespace shadows {

/// Where points relative to the camera lie in a layer: texels per metre across the light, and the
/// camera's texel.
glm::vec4 placement_of(const ParallelView& view, const scene::CameraView& camera);

/// What all layers share, and the placement of the first.
/// @param border texels on each side that filters may not pass
void set_view(
    const gpu::Program& mask,
    const ParallelView& view,
    const scene::CameraView& camera,
    int border);
void set_view(const gpu::Program& mask, const PyramidView& view, const scene::CameraView& camera);

} // namespace shadows
