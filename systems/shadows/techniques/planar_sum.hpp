// Soft shadows on planes as sums of hard ones: each point of the light is projected with its own
// matrix, darkens each pixel once, and adds its part of the light to a float.
//
// Source: P. Heckbert and M. Herf, "Simulating Soft Shadows with Graphics Hardware",
// CMU-CS-97-104, 1997.

#pragma once

#include "systems/shadows/techniques/planar_draws.hpp"
#include "systems/shadows/techniques/sum_target.hpp"

namespace shadows {

/// Where shadows are summed up: the part of the light that is blocked, 0 to 1, and a stencil that
/// tells where it may be written and which sample was the last to do so.
class PlanarSum {
public:
    /// The stencil's value where nothing has been written yet; what is 0 is never written.
    static constexpr std::uint8_t kOpen = 255;

    /// Makes the target if there is none of that size.
    /// Errors: the driver does not draw into it.
    engine::Result<void>
    prepare(const std::string& label, const glm::ivec2& size, const Remedies& remedies);

    [[nodiscard]] const gpu::Framebuffer& target() const { return sum_.framebuffer; }
    [[nodiscard]] const gpu::Texture& texture() const { return sum_.texture; }

    /// Adds the shadows of all samples. A pass on target() is open, and the stencil is open where
    /// it may be drawn.
    /// @param reopen opens the stencil again, after as many samples as it can tell apart
    template <class Reopen>
    void
    add(gpu::Frame& frame,
        const PlanarDraws& draws,
        const PlanarDraws::Runs& runs,
        std::span<const PlanarSample> samples,
        const glm::dmat4& clip_from_origin,
        const gpu::Rect& area,
        Reopen reopen) const {
        std::uint8_t mark = kOpen;
        for (const PlanarSample& sample : samples) {
            if (mark == 1) {
                reopen();
                mark = kOpen;
            }
            --mark;
            draws.draw(
                frame,
                {clip_from_origin, sample, added(sample, samples.size())},
                runs,
                adding_state(area, mark));
        }
    }

    [[nodiscard]] glm::ivec2 size() const { return {texture().width(), texture().height()}; }
    /// State of draws whose darkest fragment counts. @pre as add() has them
    [[nodiscard]] gpu::RenderState darkest_state(const gpu::Rect& area) const;

    [[nodiscard]] std::size_t gpu_bytes() const { return sum_.gpu_bytes(); }

private:
    [[nodiscard]] float added(const PlanarSample& sample, std::size_t count) const;
    [[nodiscard]] gpu::RenderState adding_state(const gpu::Rect& area, std::uint8_t mark) const;

    Remedies remedies_;
    SumTarget sum_;
};

} // namespace shadows
