// A rectangle on a receiver's plane that holds a shadow: where a texture of the shadow lies.
//
// Source: P. Heckbert and M. Herf, "Simulating Soft Shadows with Graphics Hardware",
// CMU-CS-97-104, 1997: the pyramid from a point of the light over the parallelogram. Here it is the
// projection onto the plane, followed by the plane's own coordinates.

#pragma once

#include "systems/shadows/planar_projection.hpp"

#include <algorithm>

namespace shadows {

/// World space, metres. Seen from the lit side `up` is to the left of `right`.
struct PlaneRectangle {
    glm::dvec3 corner = {};
    glm::dvec3 right = {1.0, 0.0, 0.0}; ///< unit
    glm::dvec3 up = {0.0, 0.0, -1.0};   ///< unit, at right angles to right
    glm::dvec2 size = {1.0, 1.0};

    bool operator==(const PlaneRectangle&) const = default;

    /// 0 to 1 inside. @param point need not lie on the plane
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const {
        const glm::dvec3 from = point - corner;
        return glm::dvec2(glm::dot(from, right), glm::dot(from, up)) / size;
    }
};

/// The rectangle round a box's footprint on the plane, its sides along the world's axes where the
/// plane has them.
PlaneRectangle plane_rectangle(const LitPlane& plane, const engine::WorldAabb& bounds);

/// From points of the plane, relative to `origin`, onto a texture that the rectangle fills.
glm::dmat4 texture_from_plane(const PlaneRectangle& rectangle, const glm::dvec3& origin);

inline constexpr int kSmallestKept = 16;
inline constexpr int kLargestKept = 1024;

/// Texels per side, powers of two, so that one is no larger than asked for.
/// @param texel_m the largest texel that is accepted, metres
glm::ivec2 kept_size(const PlaneRectangle& rectangle, double texel_m);

/// The larger side of a texel, metres.
inline double texel_of(const PlaneRectangle& rectangle, const glm::ivec2& size) {
    return std::max(rectangle.size.x / size.x, rectangle.size.y / size.y);
}

} // namespace shadows
