#include "systems/shadows/techniques/depth_draws.hpp"

#include <render/shared/bindings.h>

namespace shadows {

namespace {

gpu::RenderState state_of(const render::DrawBucket& bucket, const DepthDraws& how) {
    gpu::RenderState state;
    state.cull = bucket.double_sided ? gpu::Cull::none : gpu::Cull::back;
    if (how.back_faces) state.cull = gpu::Cull::front;
    state.front_face =
        bucket.mirrored ? gpu::FrontFace::clockwise : gpu::FrontFace::counter_clockwise;
    state.depth_clamp = how.pancaking && !how.per_vertex;
    return state;
}

} // namespace

engine::Result<void> draw_depth(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const render::Textures& textures,
    const render::DrawRuns& draws,
    const render::DrawList& list,
    const glm::mat4& clip_from_relative,
    const DepthDraws& how) {
    for (const render::DrawList::Run& run : list.runs) {
        gpu::Defines defines;
        if (run.bucket.alpha_masked && how.holes) defines.emplace_back("ALPHA_MASKED");
        if (how.per_vertex) defines.emplace_back("VERTEX_PANCAKING");
        const auto program = shaders.graphics("shadows/map_depth.vert", how.fragment, defines);
        if (!program) return program.error();
        (*program)->set("map_clip_from_relative", clip_from_relative);
        frame.state(state_of(run.bucket, how));
        if (run.bucket.alpha_masked) textures.get(run.bucket.texture).bind(UNIT_BASE_COLOR);
        draws.draw(frame, **program, run);
    }
    return {};
}

} // namespace shadows
