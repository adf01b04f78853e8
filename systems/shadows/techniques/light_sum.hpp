// A light of a size as a sum of points: what of each is blocked adds up in a float, whatever and
// however much blocks it, and lowers the mask by its share of what all points would give.
//
// What a point would give is the cosine between it and the surface, so points under a surface's
// horizon do not count there. Source: P. Heckbert and M. Herf, "Simulating Soft Shadows with
// Graphics Hardware", CMU-CS-97-104, 1997.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/gpu/shader_library.hpp"
#include "systems/shadows/shadow_scene.hpp"
#include "systems/shadows/techniques/sum_target.hpp"

#include <span>
#include <string>
#include <vector>

namespace shadows {

class LightSum {
public:
    /// Makes the sum as large as the picture.
    /// @param points of the light, at most 255: a stencil tells them apart
    /// Errors: a shader that does not compile; the driver does not draw into the sum.
    engine::Result<void> prepare(
        gpu::ShaderLibrary& shaders,
        const std::string& label,
        const glm::ivec2& size,
        const std::vector<LightView>& points);

    /// Where what is blocked adds up, from 0 on; clear it and its stencil.
    [[nodiscard]] const gpu::Framebuffer& target() const { return sum_.framebuffer; }
    /// State in which a program that writes what is blocked of a point, and discards where nothing
    /// is, adds it once for each pixel.
    [[nodiscard]] gpu::RenderState adding(std::size_t point) const;

    /// Lowers the mask to what is not blocked. @pre a pass on the mask is open, the G-buffer bound
    void compose(gpu::Frame& frame, const scene::CameraView& camera, const gpu::Rect& area) const;

    [[nodiscard]] std::size_t gpu_bytes() const { return sum_.gpu_bytes(); }

private:
    std::vector<LightView> points_;
    SumTarget sum_; ///< r32f; in its stencil the point, from 1 on, that added last
    const gpu::Program* program_ = nullptr;
};

} // namespace shadows
