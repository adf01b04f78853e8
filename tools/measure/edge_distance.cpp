#include "tools/measure/edge_distance.hpp"

#include <algorithm>
#include <utility>

#include "tools/measure/ranks.hpp"

namespace measure {

namespace {

constexpr float kTolerancePx = 1.0F;

/// Distances from the points of one edge to the other.
struct OneWay {
    double mean_px = 0.0;
    double rank95_px = 0.0;
    double share_within = 0.0;
};

/// @pre neither edge is empty
OneWay one_way(const Edge& from, const Edge& onto) {
    std::vector<float> distances;
    distances.reserve(from.cracks.size());
    OneWay result;
    for (const Crack& crack : from.cracks) {
        const float distance = onto.distance.to(crack);
        distances.push_back(distance);
        result.mean_px += static_cast<double>(distance);
        if (distance <= kTolerancePx) ++result.share_within;
    }
    const auto count = static_cast<double>(distances.size());
    result.mean_px /= count;
    result.share_within /= count;
    result.rank95_px = percentile(std::move(distances), 0.95);
    return result;
}

} // namespace

Edge find_edge(const Mask& mask, std::span<const PixelKind> kind) {
    std::vector<Crack> found = cracks(mask, kind);
    DistanceField distance(mask.width, mask.height, found);
    return {std::move(found), std::move(distance)};
}

EdgeDistance edge_distance(const Edge& measured, const Edge& truth, double diagonal_px) {
    if (measured.cracks.empty() && truth.cracks.empty()) return {};
    if (measured.cracks.empty() || truth.cracks.empty()) return {diagonal_px, diagonal_px, 0.0};
    const OneWay there = one_way(measured, truth);
    const OneWay back = one_way(truth, measured);
    EdgeDistance result;
    result.chamfer_px = 0.5 * (there.mean_px + back.mean_px);
    result.hausdorff95_px = std::max(there.rank95_px, back.rank95_px);
    const double sum = there.share_within + back.share_within;
    result.boundary_f1 = sum > 0.0 ? 2.0 * there.share_within * back.share_within / sum : 0.0;
    return result;
}

} // namespace measure
