// How far shadows that are not redrawn in every frame stand behind: stale shadows.
//
// The same sequence is drawn twice, as it is asked for and with every job redrawn in every frame.
// Whatever else is wrong with the technique is wrong in both, so the difference of their errors is
// what the saving costs.

#pragma once

#include <span>
#include <vector>

#include "tools/measure/figure.hpp"
#include "tools/measure/mask.hpp"

namespace measure {

struct LagFigures {
    /// Error of the sequence less that of the always redrawn one, per px of true edge: how far
    /// edges stand behind, mean over the sequence. An edge that moves v px a frame and is redrawn
    /// every N frames gives v (N - 1) / 2.
    Figure stale_px;
    /// 95th percentile, over all frames, of the distance from each edge to where it would be were
    /// it redrawn: v (N - 1) for that edge when N is at most 20.
    Figure stale_p95_px;
    Figure age_mean; ///< frames by which a job stands behind, over all jobs and frames
    Figure age_max;
};

/// Takes the frames of one sequence, in order.
class LagRecorder {
public:
    /// @param as_asked drawn by the technique with its savings
    /// @param redrawn the same frame with every job redrawn
    /// @param ages of the light's jobs, in frames; 0 stands where the world stands
    /// @pre both have the same size and truth
    void add(const Comparison& as_asked, const Comparison& redrawn, std::span<const int> ages);

    [[nodiscard]] LagFigures figures() const;

private:
    double error_px_ = 0.0;         ///< as asked
    double redrawn_error_px_ = 0.0; ///< sums over the frames
    double edge_px_ = 0.0;
    std::vector<float> distances_; ///< of the edges of all frames
    std::vector<float> ages_;
    int frames_ = 0;
};

} // namespace measure
