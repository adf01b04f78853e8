// How much a shadow's edge crawls along while the light moves: how the error of each piece of edge
// changes from frame to frame.
//
// An edge that stands beside the true one by the same amount in every frame is wrong but still; one
// that stands now before, now behind it, crawls. So the true edge is cut into tiles, each tile's
// signed error per px of edge is where its edge stands, and crawl is how much that changes.

#pragma once

#include <vector>

#include "tools/measure/figure.hpp"
#include "tools/measure/mask.hpp"

namespace measure {

inline constexpr int kCrawlTilePx = 16;
/// Shorter pieces of edge in a tile have no sure place.
inline constexpr double kMinTileEdgePx = 8.0;

/// One tile of 16 x 16 px: the true edge in it, and the signed error that lies nearest to that
/// edge.
struct EdgeTile {
    double edge_px = 0.0;
    double error_px = 0.0; ///< sum of V - V*; positive: too much light

    [[nodiscard]] bool usable() const { return edge_px >= kMinTileEdgePx; }
    /// How far the edge stands from the true one, px. @pre usable()
    [[nodiscard]] double offset_px() const { return error_px / edge_px; }
};

/// Row by row, border tiles included. Each wrong pixel counts for the tile of the true edge nearest
/// to it; pixels farther than a tile's side from every true edge count for none.
/// Cost: wrong pixels x edge within their 9 tiles.
std::vector<EdgeTile> edge_tiles(const Comparison& frame);

/// Takes the frames of a sequence in which the camera stands still, in order.
class CrawlRecorder {
public:
    /// @pre all frames have the same size
    void add(const Comparison& frame);

    /// Root of the mean square, over tiles and frames, of the change of offset_px() from one frame
    /// to the next; tiles count where they are usable in both. Px.
    [[nodiscard]] Figure figure() const;

private:
    std::vector<EdgeTile> last_;
    double squares_ = 0.0;
    double count_ = 0.0;
    int frames_ = 0;
};

} // namespace measure
