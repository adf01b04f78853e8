// Casters drawn from a light for their depth alone: what maps and textures have in common.

#pragma once

#include "engine/gpu/shader_library.hpp"
#include "engine/render/draw_runs.hpp"
#include "engine/render/textures.hpp"

#include <string>

namespace shadows {

struct DepthDraws {
    bool pancaking = true;   ///< what is nearer than the near plane keeps its shadow, at depth 1
    bool per_vertex = false; ///< the same for corners, which bends their triangles
    bool back_faces = false; ///< instead of front faces
    bool holes = true;       ///< of alpha-masked materials are left open
    std::string fragment = "shadows/map_depth.frag"; ///< compiled with ALPHA_MASKED where that is
};

/// Draws a list into the depth of the pass.
/// @param draws the list was uploaded to it
/// @param clip_from_relative relative to the origin of the list's instances
/// Errors: a shader that does not compile.
engine::Result<void> draw_depth(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const render::Textures& textures,
    const render::DrawRuns& draws,
    const render::DrawList& list,
    const glm::mat4& clip_from_relative,
    const DepthDraws& how = {});

} // namespace shadows
