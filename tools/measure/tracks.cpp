#include "tools/measure/tracks.hpp"

#include "engine/core/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tools/measure/floors.hpp"

namespace measure {

namespace {

/// One point at random from each of `count` equal runs of hits.
void choose(
    std::span<const glm::dvec3> hits,
    std::size_t count,
    engine::Random& random,
    std::vector<glm::dvec3>& points) {
    count = std::min(count, hits.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = i * hits.size() / count;
        const std::size_t end = (i + 1) * hits.size() / count;
        points.push_back(hits[begin + random.below(static_cast<std::uint32_t>(end - begin))]);
    }
}

/// Does the surface of the pixel pass through the point? Inverse depth is linear over the picture
/// of a plane, so a receding floor is followed to the point's own place inside the pixel. Its slope
/// is taken on the side where it is smaller, so that a silhouette on the other side does not count.
bool on_surface(
    const Mask& picture, std::span<const float> depth, int x, int y, const glm::dvec3& place) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto inverse = [&](int px, int py) {
        const bool inside = px >= 0 && py >= 0 && px < picture.width && py < picture.height;
        return inside ? 1.0 / static_cast<double>(depth[picture.index(px, py)]) : kNone;
    };
    const double centre = inverse(x, y);
    const auto slope = [&](int dx, int dy) {
        const double before = centre - inverse(x - dx, y - dy);
        const double after = inverse(x + dx, y + dy) - centre;
        const double smaller = std::abs(before) < std::abs(after) ? before : after;
        return std::isfinite(smaller) ? smaller : 0.0;
    };
    const double expected =
        centre + slope(1, 0) * (place.x - x - 0.5) + slope(0, 1) * (place.y - y - 0.5);
    return std::abs(expected * place.z - 1.0) < static_cast<double>(kDepthTolerance);
}

const glm::dvec3 kHalfPixel(0.5, 0.5, 0.0);

/// The pixel that shows a point, if one does.
std::optional<std::size_t>
seen_at(const Mask& picture, std::span<const float> depth, const glm::dvec3& place) {
    const bool inside = place.z > 0.0 && place.x >= 0.0 && place.y >= 0.0 && place.x < picture.width
                        && place.y < picture.height;
    if (!inside) return std::nullopt;
    const int x = static_cast<int>(place.x);
    const int y = static_cast<int>(place.y);
    if (!on_surface(picture, depth, x, y, place)) return std::nullopt;
    return picture.index(x, y);
}

/// How much more one series changes than the truth, per px of edge and frame.
Figure excess(const Tracks& tracks, const std::vector<float>& series, double mean_edge_px) {
    CHECK_EQ(series.size(), tracks.point_count * tracks.frame_count);
    CHECK_EQ(tracks.truth.size(), series.size());
    if (tracks.frame_count < 2) return Figure::missing("fewer than two frames");
    if (tracks.point_count == 0) return Figure::missing("no surface point is seen in every frame");
    if (mean_edge_px < kMinEdgePx) return Figure::missing("less than 32 px of true edge");

    std::vector<double> more(tracks.point_count);
    for (std::size_t i = tracks.point_count; i < series.size(); ++i) {
        const auto step = [&](const std::vector<float>& values) {
            return std::abs(
                static_cast<double>(values[i])
                - static_cast<double>(values[i - tracks.point_count]));
        };
        more[i % tracks.point_count] += step(series) - step(tracks.truth);
    }
    double sum = 0.0;
    for (const double value : more)
        sum += std::max(0.0, value);
    return sum * tracks.pixels_per_point
           / (static_cast<double>(tracks.frame_count - 1) * mean_edge_px);
}

} // namespace

TrackPoints choose_points(
    std::span<const glm::dvec3> first_hits,
    std::span<const glm::dvec3> last_hits,
    std::size_t count,
    std::uint64_t seed) {
    TrackPoints chosen;
    engine::Random random(seed);
    choose(first_hits, count / 2, random, chosen.points);
    choose(last_hits, count - count / 2, random, chosen.points);
    if (!chosen.points.empty())
        chosen.pixels_per_point = 0.5 * static_cast<double>(first_hits.size() + last_hits.size())
                                  / static_cast<double>(chosen.points.size());
    return chosen;
}

TrackRecorder::TrackRecorder(TrackPoints points)
    : points_(std::move(points)),
      seen_(points_.points.size(), true) {}

void TrackRecorder::add(
    const Comparison& frame,
    std::span<const float> truth_depth,
    const Projection& project,
    const std::optional<SecondGrid>& second) {
    check_sizes(frame);
    const Mask& picture = frame.truth;
    CHECK_EQ(truth_depth.size(), picture.pixel_count());
    CHECK(!second || second->visibility.size() == picture.pixel_count());
    CHECK(!second || second->depth.size() == picture.pixel_count());
    CHECK(frame_count_ == 0 || second.has_value() == !second_.empty());
    for (std::size_t i = 0; i < points_.points.size(); ++i) {
        measured_.push_back(0.0F);
        truth_.push_back(0.0F);
        if (second) second_.push_back(0.0F);
        if (!seen_[i]) continue;
        seen_[i] = false;
        const glm::dvec3 place = project(points_.points[i]);
        const auto pixel = seen_at(picture, truth_depth, place);
        if (!pixel) continue;
        const PixelKind kind = frame.kind[*pixel];
        if (kind != PixelKind::valid && kind != PixelKind::undecided) continue;
        if (second) {
            const auto sample = seen_at(picture, second->depth, place - kHalfPixel);
            if (!sample) continue;
            second_.back() = second->visibility[*sample];
        }
        seen_[i] = true;
        measured_.back() = frame.measured.visibility[*pixel];
        truth_.back() = picture.visibility[*pixel];
    }
    ++frame_count_;
}

Tracks TrackRecorder::tracks() const {
    Tracks kept;
    kept.frame_count = frame_count_;
    kept.pixels_per_point = points_.pixels_per_point;
    kept.point_count = static_cast<std::size_t>(std::count(seen_.begin(), seen_.end(), true));
    for (std::size_t i = 0; i < measured_.size(); ++i) {
        if (!seen_[i % seen_.size()]) continue;
        kept.measured.push_back(measured_[i]);
        kept.truth.push_back(truth_[i]);
        if (!second_.empty()) kept.second.push_back(second_[i]);
    }
    return kept;
}

Figure flicker(const Tracks& tracks, double mean_edge_px) {
    return excess(tracks, tracks.measured, mean_edge_px);
}

Figure truth_flicker(const Tracks& tracks, double mean_edge_px) {
    if (tracks.second.empty() && tracks.point_count * tracks.frame_count > 0)
        return Figure::missing("the truth was not sampled on a second grid");
    return excess(tracks, tracks.second, mean_edge_px);
}

} // namespace measure
