#include "tools/measure/lag.hpp"

#include <algorithm>
#include <cmath>

#include "tools/measure/edge_distance.hpp"
#include "tools/measure/floors.hpp"
#include "tools/measure/ranks.hpp"

namespace measure {

namespace {

double error_px(const Comparison& frame) {
    double sum = 0.0;
    for (std::size_t i = 0; i < frame.kind.size(); ++i)
        if (frame.kind[i] == PixelKind::valid)
            sum += std::abs(
                static_cast<double>(frame.measured.visibility[i])
                - static_cast<double>(frame.truth.visibility[i]));
    return sum;
}

} // namespace

void LagRecorder::add(
    const Comparison& as_asked, const Comparison& redrawn, std::span<const int> ages) {
    check_sizes(as_asked);
    check_sizes(redrawn);
    CHECK_EQ(as_asked.truth.width, redrawn.truth.width);
    CHECK_EQ(as_asked.truth.height, redrawn.truth.height);
    ++frames_;
    edge_px_ += crofton_length(cracks(redrawn.truth, redrawn.kind).size());
    error_px_ += error_px(as_asked);
    redrawn_error_px_ += error_px(redrawn);
    for (const int age : ages)
        ages_.push_back(static_cast<float>(age));

    const std::vector<Crack> edge = cracks(as_asked.measured, as_asked.kind);
    if (as_asked.measured.visibility == redrawn.measured.visibility) {
        distances_.insert(distances_.end(), edge.size(), 0.0F);
        return;
    }
    const float diagonal = std::hypot(
        static_cast<float>(as_asked.truth.width), static_cast<float>(as_asked.truth.height));
    const Edge wanted = find_edge(redrawn.measured, redrawn.kind);
    for (const Crack& crack : edge)
        distances_.push_back(std::min(diagonal, wanted.distance.to(crack)));
}

LagFigures LagRecorder::figures() const {
    LagFigures result;
    result.stale_px = frames_ == 0 || edge_px_ / frames_ < kMinEdgePx
                          ? Figure::missing("less than 32 px of true edge")
                          : Figure((error_px_ - redrawn_error_px_) / edge_px_);
    result.stale_p95_px = distances_.empty() ? Figure::missing("no edge was drawn")
                                             : Figure(percentile(distances_, 0.95));
    if (ages_.empty()) {
        result.age_mean = result.age_max = Figure::missing("nothing had to be drawn");
    } else {
        result.age_mean = mean(ages_);
        result.age_max = static_cast<double>(*std::max_element(ages_.begin(), ages_.end()));
    }
    return result;
}

} // namespace measure
