// A flat receiver's shadow as a texture of its own: drawn from the points of the light once, looked
// up until something moves.
//
// Source: P. Heckbert and M. Herf, "Simulating Soft Shadows with Graphics Hardware",
// CMU-CS-97-104, 1997.

#pragma once

#include "engine/render/light_visibility.hpp"
#include "systems/shadows/planar_rectangle.hpp"
#include "systems/shadows/techniques/planar_sum.hpp"

namespace shadows {

/// The texture; knows nothing of receivers' ids and screens.
class PlaneTexture {
public:
    /// Makes the texture if there is none of that size; what it holds is of no use then.
    /// Errors: the driver does not draw into it.
    engine::Result<void> prepare(
        const std::string& label,
        const PlaneRectangle& rectangle,
        const glm::ivec2& size,
        const Remedies& remedies);

    /// Draws the casters' shadows from all samples.
    void draw(
        gpu::Frame& frame,
        const PlanarDraws& draws,
        const PlanarDraws::Runs& runs,
        std::span<const PlanarSample> samples) const;

    /// Lowers the mask where a receiver on the plane is seen.
    /// @param program of screen_ray.vert and plane_texture.frag
    /// @pre a pass is open, its mask blends by minimum, G-buffer and depth are bound
    void look_up(
        gpu::Frame& frame,
        const gpu::Program& program,
        const scene::CameraView& camera,
        std::uint32_t receiver,
        gpu::RenderState state) const;

    [[nodiscard]] const PlaneRectangle& rectangle() const { return rectangle_; }
    [[nodiscard]] double texel_m() const { return texel_of(rectangle_, sum_.size()); }
    [[nodiscard]] std::size_t gpu_bytes() const { return sum_.gpu_bytes(); }

private:
    std::string label_;
    PlaneRectangle rectangle_;
    PlanarSum sum_;
};

} // namespace shadows
