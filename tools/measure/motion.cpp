#include "tools/measure/motion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tools/measure/edges.hpp"

namespace measure {

namespace {

struct TileChange {
    double measured = 0.0;
    double truth = 0.0;
};

double change(const Mask& before, const Mask& after, std::size_t i) {
    return std::abs(
        static_cast<double>(after.visibility[i]) - static_cast<double>(before.visibility[i]));
}

} // namespace

Figure changed_px(std::span<const Mask> frames) {
    if (frames.size() < 2) return Figure::missing("fewer than two frames");
    std::size_t count = 0;
    for (std::size_t i = 0; i < frames[0].pixel_count(); ++i) {
        const auto first = std::bit_cast<std::uint32_t>(frames[0].visibility[i]);
        const bool changed = std::any_of(frames.begin() + 1, frames.end(), [&](const Mask& frame) {
            CHECK_EQ(frame.pixel_count(), frames[0].pixel_count());
            return std::bit_cast<std::uint32_t>(frame.visibility[i]) != first;
        });
        if (changed) ++count;
    }
    return static_cast<double>(count);
}

double
pop(const Comparison& before, const Comparison& after, std::span<const float> tile_contrast) {
    check_sizes(before);
    check_sizes(after);
    CHECK_EQ(before.truth.width, after.truth.width);
    CHECK_EQ(before.truth.height, after.truth.height);
    const int columns = (after.truth.width + kPopTilePx - 1) / kPopTilePx;
    const int rows = (after.truth.height + kPopTilePx - 1) / kPopTilePx;
    std::vector<TileChange> tiles(
        static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    CHECK(tile_contrast.empty() || tile_contrast.size() == tiles.size());

    for (int y = 0; y < after.truth.height; ++y)
        for (int x = 0; x < after.truth.width; ++x) {
            const std::size_t i = after.truth.index(x, y);
            if (before.kind[i] != PixelKind::valid || after.kind[i] != PixelKind::valid) continue;
            TileChange& tile =
                tiles[static_cast<std::size_t>(y / kPopTilePx * columns + x / kPopTilePx)];
            tile.measured += change(before.measured, after.measured, i);
            tile.truth += change(before.truth, after.truth, i);
        }

    constexpr double kTileArea = kPopTilePx * kPopTilePx;
    double largest = 0.0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const double contrast = tile_contrast.empty() ? 1.0 : static_cast<double>(tile_contrast[i]);
        largest = std::max(largest, contrast * (tiles[i].measured - tiles[i].truth) / kTileArea);
    }
    return largest;
}

void MotionRecorder::add(
    Comparison frame,
    std::span<const float> truth_depth,
    const Projection& project,
    const std::optional<SecondGrid>& second) {
    check_sizes(frame);
    if (!tracks_.empty()) tracks_.add(frame, truth_depth, project, second);
    if (camera_stands_) crawl_.add(frame);
    if (last_) pop_ = std::max(pop_, pop(*last_, frame));
    edge_px_sum_ += crofton_length(cracks(frame.truth, frame.kind).size());
    ++frames_;
    last_ = std::move(frame);
}

MotionFigures MotionRecorder::figures(Figure changed) const {
    MotionFigures result;
    result.frames = frames_;
    result.changed_px = std::move(changed);
    result.crawl_px = camera_stands_ ? crawl_.figure() : Figure::missing("the camera moves");
    if (has_lag_) result.lag = lag_.figures();
    if (frames_ < 2) {
        const Figure missing = Figure::missing("fewer than two frames");
        result.mean_edge_px = result.tracked_points = result.flicker_per_px =
            result.truth_flicker_per_px = result.flicker_ratio = result.pop = missing;
        return result;
    }
    result.mean_edge_px = edge_px_sum_ / frames_;
    result.pop = pop_;
    if (tracks_.empty()) {
        result.tracked_points = result.flicker_per_px = result.truth_flicker_per_px =
            result.flicker_ratio = Figure::missing("no surface points were chosen");
        return result;
    }
    const Tracks tracks = tracks_.tracks();
    result.tracked_points = static_cast<double>(tracks.point_count);
    result.flicker_per_px = flicker(tracks, edge_px_sum_ / frames_);
    result.truth_flicker_per_px = truth_flicker(tracks, edge_px_sum_ / frames_);
    const Figure& own = result.truth_flicker_per_px;
    if (!own.known())
        result.flicker_ratio = own;
    else if (own.value() == 0.0)
        result.flicker_ratio = Figure::missing("the truth itself does not flicker");
    else if (result.flicker_per_px.known())
        result.flicker_ratio = result.flicker_per_px.value() / own.value();
    return result;
}

} // namespace measure
