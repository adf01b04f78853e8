// The socket by which shadows join the frame without the frame knowing them.

#pragma once

#include "engine/core/result.hpp"
#include "engine/gpu/frame.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/render/geometry.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/receivers.hpp"
#include "engine/scene/world.hpp"

#include <span>

namespace render {

/// Where the visibility of one light goes: an R8 layer that holds 1 everywhere. Passes lower it
/// (blend min).
struct VisibilityTarget {
    const gpu::Framebuffer& mask; ///< colour only
    /// The same with the frame's depth and stencil; null unless needs_stencil(). The stencil is 0
    /// everywhere, and whoever writes it leaves it so.
    const gpu::Framebuffer* mask_with_stencil;
    const gpu::Texture& gbuffer; ///< rg32ui, as include/gbuffer.glsl packs it
    const gpu::Texture& facets;  ///< r32ui, normals of the triangles
    const gpu::Texture& depth;   ///< reversed; not attached to `mask`
    gpu::Rect area;              ///< what of the mask will be read: touch nothing else
};

/// What a frame is drawn from.
struct FrameInput {
    const scene::World& world;
    const scene::ReceiverTable& receivers;
    const scene::CameraView& camera;
    std::span<const scene::PlacedLight> lights; ///< those that are on
};

class LightVisibility {
public:
    virtual ~LightVisibility() = default;

    /// CPU: decides everything for this frame. Errors end the frame.
    virtual engine::Result<void> prepare(const FrameInput& input) = 0;
    /// Whether the light (an index into FrameInput::lights) needs a mask at all; without one it is
    /// lit everywhere.
    [[nodiscard]] virtual bool serves(std::size_t light) const = 0;
    /// Whether anything of this frame works with the stencil; without it the depth buffer is half
    /// as large.
    [[nodiscard]] virtual bool needs_stencil() const { return false; }
    /// GPU: redraws what the masks are made from. Errors: a shader that does not compile.
    virtual engine::Result<void>
    refresh(gpu::Frame& frame, gpu::ShaderLibrary& shaders, const Geometry& geometry) = 0;
    /// GPU: lowers the light's mask. @pre serves(light)
    virtual void apply(gpu::Frame& frame, std::size_t light, const VisibilityTarget& target) = 0;
};

} // namespace render
