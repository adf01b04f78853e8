// The packed G-buffer: what is lit, the triangles it consists of, reversed depth with stencil, and
// the pass that fills them.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/render/draw_runs.hpp"
#include "engine/render/textures.hpp"

namespace render {

/// Sized like the picture.
class GBuffer {
public:
    /// Errors: the driver draws into no such set of textures.
    static engine::Result<GBuffer> make(int width, int height, bool with_stencil);

    [[nodiscard]] const gpu::Texture& surface() const {
        return surface_;
    } ///< rg32ui, include/gbuffer.glsl
    [[nodiscard]] const gpu::Texture& facets() const {
        return facets_;
    } ///< r32ui, normals of triangles
    [[nodiscard]] const gpu::Texture& depth() const {
        return depth_;
    } ///< reversed; depth32f, or depth32f_stencil8 where a technique needs it
    [[nodiscard]] const gpu::Framebuffer& target() const { return target_; }

private:
    gpu::Texture surface_;
    gpu::Texture facets_;
    gpu::Texture depth_;
    gpu::Framebuffer target_;
};

/// Draws every run of the list once. Stencil starts at 0.
/// Errors: a shader that does not compile.
engine::Result<void> draw_geometry(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const GBuffer& gbuffer,
    const Textures& textures,
    const DrawRuns& draws,
    const DrawList& list);

} // namespace render
