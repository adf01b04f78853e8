#include "systems/shadows/planar_rectangle.hpp"

#include <cmath>

namespace shadows {

namespace {

/// Room on each side, as a part of it: half a texel of the smallest texture, so that filtering at
/// the bounds' edge still sees what lies beyond.
constexpr double kRoom = 0.04;
/// The least room, metres: a texture of it has an area.
constexpr double kLeastSide = 1e-3;

int texels_for(double side, double texel_m) {
    int texels = kSmallestKept;
    while (texels < kLargestKept && side > texel_m * texels)
        texels *= 2;
    return texels;
}

} // namespace

PlaneRectangle plane_rectangle(const LitPlane& plane, const engine::WorldAabb& bounds) {
    // Of the world's axes the one that lies flattest, so that floors and walls are held tightly.
    const glm::dvec3 slant = glm::abs(plane.normal);
    const glm::dvec3 axis =
        slant.x <= slant.z ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    PlaneRectangle rectangle;
    rectangle.right = glm::normalize(axis - plane.normal * glm::dot(axis, plane.normal));
    rectangle.up = glm::cross(plane.normal, rectangle.right);
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner = bounds.corner(i);
        const glm::dvec2 at(glm::dot(corner, rectangle.right), glm::dot(corner, rectangle.up));
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const glm::dvec2 room = glm::max((high - low) * kRoom, glm::dvec2(kLeastSide));
    low -= room;
    high += room;
    rectangle.size = high - low;
    rectangle.corner = plane.normal * plane.offset + rectangle.right * low.x + rectangle.up * low.y;
    return rectangle;
}

glm::dmat4 texture_from_plane(const PlaneRectangle& rectangle, const glm::dvec3& origin) {
    const glm::dvec3 row_0 = rectangle.right * (2.0 / rectangle.size.x);
    const glm::dvec3 row_1 = rectangle.up * (2.0 / rectangle.size.y);
    const glm::dvec3 from = origin - rectangle.corner;
    // Any depth between the near plane and infinity will do: nothing is hidden on a plane.
    const glm::dmat4 rows(
        glm::dvec4(row_0, glm::dot(row_0, from) - 1.0),
        glm::dvec4(row_1, glm::dot(row_1, from) - 1.0),
        glm::dvec4(0.0, 0.0, 0.0, 0.5),
        glm::dvec4(0.0, 0.0, 0.0, 1.0));
    return glm::transpose(rows);
}

glm::ivec2 kept_size(const PlaneRectangle& rectangle, double texel_m) {
    return {texels_for(rectangle.size.x, texel_m), texels_for(rectangle.size.y, texel_m)};
}

} // namespace shadows
