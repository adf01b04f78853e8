#include "engine/render/gbuffer.hpp"

#include "engine/gpu/pass.hpp"

#include <render/shared/bindings.h>

namespace render {

namespace {

gpu::Defines defines_of(const DrawBucket& bucket) {
    gpu::Defines defines;
    if (bucket.texture != scene::kNoTexture) defines.emplace_back("TEXTURED");
    if (bucket.alpha_masked) defines.emplace_back("ALPHA_MASKED");
    if (bucket.double_sided) defines.emplace_back("DOUBLE_SIDED");
    return defines;
}

gpu::RenderState state_of(const DrawBucket& bucket) {
    gpu::RenderState state;
    state.cull = bucket.double_sided ? gpu::Cull::none : gpu::Cull::back;
    state.front_face =
        bucket.mirrored ? gpu::FrontFace::clockwise : gpu::FrontFace::counter_clockwise;
    return state;
}

} // namespace

engine::Result<GBuffer> GBuffer::make(int width, int height, bool with_stencil) {
    GBuffer made;
    made.surface_ = gpu::Texture(
        "gbuffer/surface", {.format = gpu::Format::rg32ui, .width = width, .height = height});
    made.facets_ = gpu::Texture(
        "gbuffer/facets", {.format = gpu::Format::r32ui, .width = width, .height = height});
    made.depth_ = gpu::Texture(
        "gbuffer/depth",
        {.format = with_stencil ? gpu::Format::depth32f_stencil8 : gpu::Format::depth32f,
         .width = width,
         .height = height});
    auto target = gpu::Framebuffer::make(
        "gbuffer",
        {.colors = {{&made.surface_}, {&made.facets_}}, .depth = gpu::Attachment{&made.depth_}});
    if (!target) return target.error();
    made.target_ = *std::move(target);
    return made;
}

engine::Result<void> draw_geometry(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const GBuffer& gbuffer,
    const Textures& textures,
    const DrawRuns& draws,
    const DrawList& list) {
    const gpu::ScopedPass pass(
        frame,
        "geometry",
        gbuffer.target(),
        {.color = glm::vec4(0.0F), .depth = 0.0F, .stencil = 0});
    for (const DrawList::Run& run : list.runs) {
        const auto program =
            shaders.graphics("render/gbuffer.vert", "render/gbuffer.frag", defines_of(run.bucket));
        if (!program) return program.error();
        frame.state(state_of(run.bucket));
        if (run.bucket.texture != scene::kNoTexture)
            textures.get(run.bucket.texture).bind(UNIT_BASE_COLOR);
        draws.draw(frame, **program, run);
    }
    return {};
}

} // namespace render
