// How far two shadow edges lie apart, in px.

#pragma once

#include "tools/measure/edges.hpp"

namespace measure {

/// The edge of one mask, with the distance to it from everywhere.
struct Edge {
    std::vector<Crack> cracks;
    DistanceField distance;
};

Edge find_edge(const Mask& mask, std::span<const PixelKind> kind);

struct EdgeDistance {
    double chamfer_px = 0.0;     ///< mean over both edges of the distance to the other
    double hausdorff95_px = 0.0; ///< the larger of both 95th percentiles of that distance
    double boundary_f1 = 1.0;    ///< at a tolerance of 1 px
};

/// Two empty edges agree; one empty edge is as wrong as can be: the diagonal, and F1 = 0.
/// Source: Martin, Fowlkes and Malik, "Learning to Detect Natural Image Boundaries", 2004 (F
/// measure); Huttenlocher, Klanderman and Rucklidge, "Comparing Images Using the Hausdorff
/// Distance", 1993 (ranks).
EdgeDistance edge_distance(const Edge& measured, const Edge& truth, double diagonal_px);

} // namespace measure
