#include "tools/measure/crawl.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tools/measure/edges.hpp"

namespace measure {

namespace {

/// The picture's tiles, and the true edge sorted into them.
class Tiles {
public:
    explicit Tiles(const Comparison& frame)
        : columns_((frame.truth.width + kCrawlTilePx - 1) / kCrawlTilePx),
          rows_((frame.truth.height + kCrawlTilePx - 1) / kCrawlTilePx),
          cracks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
        // Places count in half pixels; an edge on a tile's border belongs to the tile before it.
        for (const Crack& crack : cracks(frame.truth, frame.kind))
            cracks_[index((crack.x - 1) / 2 / kCrawlTilePx, (crack.y - 1) / 2 / kCrawlTilePx)]
                .push_back(crack);
    }

    [[nodiscard]] std::size_t count() const { return cracks_.size(); }
    [[nodiscard]] double edge_px(std::size_t tile) const {
        return crofton_length(cracks_[tile].size());
    }

    /// The tile of the edge nearest to a pixel; count() when there is none near.
    [[nodiscard]] std::size_t nearest(int x, int y) const {
        const int column = x / kCrawlTilePx;
        const int row = y / kCrawlTilePx;
        double least = 2.0 * kCrawlTilePx;
        least *= least; // squared, in half pixels
        std::size_t found = count();
        for (int j = std::max(0, row - 1); j <= std::min(rows_ - 1, row + 1); ++j)
            for (int i = std::max(0, column - 1); i <= std::min(columns_ - 1, column + 1); ++i)
                for (const Crack& crack : cracks_[index(i, j)]) {
                    const double dx = crack.x - (2 * x + 1);
                    const double dy = crack.y - (2 * y + 1);
                    const double square = dx * dx + dy * dy;
                    if (square >= least) continue;
                    least = square;
                    found = index(i, j);
                }
        return found;
    }

private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)
               + static_cast<std::size_t>(column);
    }

    int columns_;
    int rows_;
    std::vector<std::vector<Crack>> cracks_;
};

} // namespace

std::vector<EdgeTile> edge_tiles(const Comparison& frame) {
    check_sizes(frame);
    const Tiles tiles(frame);
    std::vector<EdgeTile> result(tiles.count());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i].edge_px = tiles.edge_px(i);
    for (int y = 0; y < frame.truth.height; ++y)
        for (int x = 0; x < frame.truth.width; ++x) {
            const std::size_t pixel = frame.truth.index(x, y);
            const double error = static_cast<double>(frame.measured.visibility[pixel])
                                 - static_cast<double>(frame.truth.visibility[pixel]);
            if (error == 0.0 || frame.kind[pixel] != PixelKind::valid) continue;
            const std::size_t tile = tiles.nearest(x, y);
            if (tile < result.size()) result[tile].error_px += error;
        }
    return result;
}

void CrawlRecorder::add(const Comparison& frame) {
    std::vector<EdgeTile> tiles = edge_tiles(frame);
    CHECK(frames_ == 0 || tiles.size() == last_.size());
    for (std::size_t i = 0; frames_ > 0 && i < tiles.size(); ++i) {
        if (!tiles[i].usable() || !last_[i].usable()) continue;
        const double change = tiles[i].offset_px() - last_[i].offset_px();
        squares_ += change * change;
        ++count_;
    }
    last_ = std::move(tiles);
    ++frames_;
}

Figure CrawlRecorder::figure() const {
    if (frames_ < 2) return Figure::missing("fewer than two frames");
    if (count_ == 0.0) return Figure::missing("no tile of 16 px keeps 8 px of true edge");
    return std::sqrt(squares_ / count_);
}

} // namespace measure
