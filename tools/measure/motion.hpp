// The figures of a sequence of frames: what flickers, crawls, lags or pops that should not.
//
// Change itself is no error, since the true shadow changes too. Every figure is the change that the
// technique adds to the change of the truth, both read at the same pixels, so that resampling
// cancels.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <utility>

#include "tools/measure/crawl.hpp"
#include "tools/measure/figure.hpp"
#include "tools/measure/lag.hpp"
#include "tools/measure/mask.hpp"
#include "tools/measure/tracks.hpp"

namespace measure {

struct MotionFigures {
    double frames = 0.0;
    Figure changed_px;           ///< pixels that change at all while nothing moves
    Figure mean_edge_px;         ///< true edge length, mean over the frames
    Figure tracked_points;       ///< surface points seen in every frame
    Figure flicker_per_px;       ///< flips per px of true edge and frame
    Figure truth_flicker_per_px; ///< the same of the truth, sampled on a second grid
    Figure flicker_ratio;        ///< of the two: 1 is as still as the truth
    /// The largest sudden change of a tile beyond the truth's own, in units of contrast.
    Figure pop;
    Figure crawl_px; ///< how much edges move to and fro along the true one, see CrawlRecorder
    LagFigures lag;  ///< how far shadows that are not redrawn stand behind
};

/// Pixels whose value differs, bit for bit, from the first frame in any later one.
/// @pre all frames have the same size
Figure changed_px(std::span<const Mask> frames);

inline constexpr int kPopTilePx = 32;

/// The largest change from one frame to the next of the mean visibility change over a tile, beyond
/// the truth's own; never negative. A pixel that is not valid in both frames counts as unchanged.
/// @param tile_contrast how much of the luminance this light gives to each tile of 32 x 32 px, row
/// by row,
///                      border tiles included; empty for 1 everywhere
/// @pre both frames have the same size
double
pop(const Comparison& before, const Comparison& after, std::span<const float> tile_contrast = {});

/// Takes the frames of one sequence in order and keeps no more than the last.
class MotionRecorder {
public:
    /// @param camera_stands the same pixels show the same place in every frame: crawl is measured
    explicit MotionRecorder(TrackPoints points = {}, bool camera_stands = false)
        : tracks_(std::move(points)),
          camera_stands_(camera_stands) {}

    /// @param truth_depth view depth of the true surface per pixel, metres; infinite where there is
    /// none
    /// @param project     into this frame's picture
    /// Both may be left out when the recorder was given no points.
    void
    add(Comparison frame,
        std::span<const float> truth_depth = {},
        const Projection& project = {},
        const std::optional<SecondGrid>& second = {});

    /// A frame that was given to add(), and the same with every job redrawn: see LagRecorder.
    void add_lag(const Comparison& as_asked, const Comparison& redrawn, std::span<const int> ages) {
        lag_.add(as_asked, redrawn, ages);
        has_lag_ = true;
    }

    /// @param changed what changed_px() found in a sequence where nothing moved
    [[nodiscard]] MotionFigures
    figures(Figure changed = Figure::missing("no still sequence was drawn")) const;

private:
    TrackRecorder tracks_;
    CrawlRecorder crawl_;
    LagRecorder lag_;
    bool camera_stands_ = false;
    bool has_lag_ = false;
    std::optional<Comparison> last_;
    double pop_ = 0.0;
    double edge_px_sum_ = 0.0;
    int frames_ = 0;
};

nlohmann::json to_json(const MotionFigures& figures);

} // namespace measure
