// The frame, top to bottom: geometry once, jobs due, masks, lighting. Owns what lasts from frame to
// frame.

#pragma once

#include "engine/core/image.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/render/gbuffer.hpp"
#include "engine/render/light_visibility.hpp"
#include "engine/render/lighting.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace render {

/// One view's worth of settings for Renderer::draw.
struct FrameSettings {
    std::optional<float> exposure = {}; ///< none: default_exposure of the frame's lights
};

class Renderer {
public:
    /// Needs a current context that outlives it. @param shader_folders of modules besides "render"
    /// and "gpu"
    explicit Renderer(std::vector<gpu::ShaderFolder> shader_folders = {});

    /// Draws the world as the camera sees it. The same input gives the same pixels.
    /// @param visibility null: no shadows, no masks, and no cost of either
    /// @param target colour only, as large as the camera's picture
    /// Errors: a shader that does not compile, a technique that cannot serve.
    engine::Result<void> draw(
        const scene::World& world,
        const scene::CameraView& camera,
        std::span<const scene::PlacedLight> lights,
        LightVisibility* visibility,
        const gpu::Framebuffer& target,
        const FrameSettings& settings = {});

    /// The mask of one light of the last frame, drawn again by itself: 255 lit, top row first.
    /// @pre the last draw had this visibility; light < its lights
    engine::Result<engine::Image> draw_mask(std::size_t light, LightVisibility& visibility);

    [[nodiscard]] gpu::Frame& frame() { return frame_; }
    [[nodiscard]] gpu::ShaderLibrary& shaders() { return shaders_; }
    /// Of the last frame. @pre a frame was drawn
    [[nodiscard]] const GBuffer& gbuffer() const { return *gbuffer_; }
    [[nodiscard]] const scene::ReceiverTable& receivers() const { return receivers_; }

private:
    /// One mask layer, as a texture to read and a target to lower.
    struct MaskLayers {
        gpu::Texture texture;
        std::vector<gpu::Framebuffer> targets;      ///< one per layer
        std::vector<gpu::Framebuffer> with_stencil; ///< the same; empty without a stencil
    };

    engine::Result<void> draw_frame(
        const scene::World& world,
        const scene::CameraView& camera,
        std::span<const scene::PlacedLight> lights,
        LightVisibility* visibility,
        const gpu::Framebuffer& target,
        const FrameSettings& settings);
    void sync(const scene::World& world);
    void upload_view(const scene::World& world, const scene::CameraView& camera);
    engine::Result<void> resize(int width, int height, bool with_stencil);
    engine::Result<void> reserve_masks(int layers);
    void draw_masks(const LightBatch& batch, LightVisibility& visibility);
    [[nodiscard]] VisibilityTarget mask_target(std::size_t layer, const gpu::Rect& area) const;
    engine::Result<void> light_frame(
        const FrameInput& input,
        LightVisibility* visibility,
        const gpu::Framebuffer& target,
        const FrameSettings& settings);
    engine::Result<const gpu::Framebuffer*> light_target(std::size_t batch);

    gpu::ShaderLibrary shaders_;
    gpu::Frame frame_;
    gpu::Buffer frame_constants_;
    GeometryPool pool_;
    Textures textures_;
    DrawItems items_;
    DrawRuns draws_;
    DrawList list_;
    Lighting lighting_;
    scene::ReceiverTable receivers_;
    std::uint64_t world_ = 0; ///< number of the world that was drawn last
    std::uint64_t mesh_versions_ = 0;
    std::optional<GBuffer> gbuffer_;
    MaskLayers masks_;
    std::array<gpu::Texture, 2> light_textures_; ///< light of earlier batches, in turns
    std::array<gpu::Framebuffer, 2> light_targets_;
};

} // namespace render
