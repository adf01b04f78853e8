// A headless context with everything that draws a level into a picture.

#pragma once

#include "engine/gpu/context.hpp"
#include "engine/render/renderer.hpp"
#include "systems/shadows/shadow_system.hpp"

#include <memory>
#include <vector>

#include "tools/gnomon/level.hpp"

namespace gnomon {

class Studio {
public:
    /// Errors: no OpenGL on this machine (exit code 77).
    static engine::Result<std::unique_ptr<Studio>> open(int width, int height);

    /// Draws one frame and waits until the device has finished it.
    /// @param with_shadows false: as if there were no shadow system at all
    engine::Result<void>
    draw(const Level& level, const scene::CameraView& camera, bool with_shadows = true);

    /// What the last draw left.
    [[nodiscard]] engine::Image color() const;
    /// One value a pixel, top row first.
    struct Surfaces {
        std::vector<std::uint32_t> receiver; ///< its id; 0 where nothing is
        std::vector<glm::vec3> normal;       ///< unit, as it is shaded
    };
    [[nodiscard]] Surfaces surfaces() const;
    [[nodiscard]] std::vector<std::uint32_t> receiver_ids() const { return surfaces().receiver; }
    /// View depth in metres, infinite where nothing is.
    [[nodiscard]] std::vector<float> view_depth(const scene::CameraView& camera) const;
    /// Visibility of a light, 8-bit grey. @param light index into lights()
    engine::Result<engine::Image> mask(std::size_t light) {
        return renderer_.draw_mask(light, *shadows_);
    }

    /// A shadow system for this device, which has drawn nothing yet; with the remedies of the
    /// studio's own.
    [[nodiscard]] std::unique_ptr<shadows::ShadowSystem> new_shadows() const;
    /// Frames from now on are drawn with another shadow system; null: with the studio's own.
    /// @param shadows outlives its use
    void use_shadows(shadows::ShadowSystem* shadows) {
        shadows_ = shadows == nullptr ? own_shadows_.get() : shadows;
    }

    /// Lights of the last frame, sorted by name.
    [[nodiscard]] const std::vector<scene::PlacedLight>& lights() const { return lights_; }
    [[nodiscard]] render::Renderer& renderer() { return renderer_; }
    [[nodiscard]] shadows::ShadowSystem& shadows() { return *shadows_; }
    [[nodiscard]] const gpu::DeviceInfo& device() const { return context_->device(); }

private:
    explicit Studio(std::unique_ptr<gpu::Context> context);

    std::unique_ptr<gpu::Context> context_;
    render::Renderer renderer_;
    std::unique_ptr<shadows::ShadowSystem> own_shadows_;
    shadows::ShadowSystem* shadows_; ///< that draws
    gpu::Texture color_;
    gpu::Framebuffer target_;
    std::vector<scene::PlacedLight> lights_;
};

} // namespace gnomon
