// How coarse a technique is at one point of the picture: what a measurement has to forgive.

#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace shadows {

/// What one pixel shows.
struct SurfacePoint {
    glm::dvec3 position = {};
    glm::dvec3 normal = {}; ///< unit, geometric, turned to the light
};

/// Zero for techniques that have no grid of their own.
struct Resolution {
    double texel_px = 0.0; ///< pixels that one texel covers, along the way in which they are most
    double shift_px = 0.0; ///< how far an edge may move because depth is not known better
};

/// The larger of each.
inline Resolution coarser(const Resolution& a, const Resolution& b) {
    return {std::max(a.texel_px, b.texel_px), std::max(a.shift_px, b.shift_px)};
}

} // namespace shadows
