// Surface points followed through a sequence, and how much more their shadow flickers than it
// should.

#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tools/measure/figure.hpp"
#include "tools/measure/mask.hpp"

namespace measure {

/// A world point to picture coordinates (px, origin top left, first pixel's centre at 0.5) and view
/// depth in metres; a depth <= 0 is behind the camera.
using Projection = std::function<glm::dvec3(const glm::dvec3& point)>;

/// Points to follow, chosen evenly over the pixels of some frames.
struct TrackPoints {
    std::vector<glm::dvec3> points; ///< world space, metres
    double pixels_per_point = 1.0;  ///< how many pixels of one frame each point stands for
};

/// Half of `count` points from each frame (all of a frame's hits when it has fewer), stratified
/// over its pixels.
/// @param first_hits, last_hits true primary hits of the first and the last frame, one per pixel
/// with a surface
TrackPoints choose_points(
    std::span<const glm::dvec3> first_hits,
    std::span<const glm::dvec3> last_hits,
    std::size_t count,
    std::uint64_t seed);

/// The truth sampled once more, half a pixel to the right of the pixels' centres and below them: an
/// equally fine picture of it that knows nothing of the first. One value per pixel in each.
struct SecondGrid {
    std::span<const float> visibility;
    std::span<const float> depth; ///< view depth, metres; infinite where nothing is
};

/// Visibility of the points that were seen in every frame: frame after frame, point_count values
/// each.
struct Tracks {
    std::size_t point_count = 0;
    std::size_t frame_count = 0;
    double pixels_per_point = 1.0;
    std::vector<float> measured;
    std::vector<float> truth;
    std::vector<float> second = {}; ///< the truth on the second grid; empty when none was given
};

/// Reads both masks where the points appear, frame after frame, at the nearest pixel.
class TrackRecorder {
public:
    explicit TrackRecorder(TrackPoints points);

    [[nodiscard]] bool empty() const { return points_.points.empty(); }

    /// A point that is hidden, outside the picture or on an unusable pixel is dropped for good.
    /// Undecided pixels are read: hardly any point near an edge would otherwise survive a long
    /// sequence, and both masks are read alike.
    /// @param truth_depth view depth of the true surface per pixel, metres; infinite where there is
    /// none
    /// @param second read at its own nearest sample, where the point must be seen too; given for
    /// every frame or for none
    void
    add(const Comparison& frame,
        std::span<const float> truth_depth,
        const Projection& project,
        const std::optional<SecondGrid>& second = {});

    [[nodiscard]] Tracks tracks() const;

private:
    TrackPoints points_;
    std::vector<bool> seen_;
    std::vector<float> measured_; ///< all points, dropped ones too
    std::vector<float> truth_;
    std::vector<float> second_;
    std::size_t frame_count_ = 0;
};

/// Total variation of the measured visibility beyond the truth's own, summed over the surface, per
/// px of true edge and frame. A map whose texels of f px fall differently in every frame gives
/// 0.331 f with nearest sampling, 0.270 f bilinear, 0.171 f with 3x3 bilinear PCF; a map that stays
/// on its texel grid gives 0.
Figure flicker(const Tracks& tracks, double mean_edge_px);

/// The same of the truth on the second grid: what any picture with one sample a pixel has to show,
/// since its samples do not fall where the first grid's do.
Figure truth_flicker(const Tracks& tracks, double mean_edge_px);

} // namespace measure
