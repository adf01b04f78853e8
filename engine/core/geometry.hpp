// Boxes, planes and view frusta in plain arithmetic. World positions are doubles, so that a level
// 100 km from the origin keeps its millimetres; everything relative to a camera or a mesh is float.

#pragma once

#include <glm/glm.hpp>

#include <array>
#include <limits>

namespace engine {

/// Axis-aligned box. The default is empty: min > max, grows to any point, intersects nothing.
template <class Vec>
struct Box {
    using Scalar = typename Vec::value_type;
    Vec min = Vec(std::numeric_limits<Scalar>::infinity());
    Vec max = Vec(-std::numeric_limits<Scalar>::infinity());

    [[nodiscard]] bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    [[nodiscard]] Vec centre() const { return (min + max) * Scalar(0.5); }
    [[nodiscard]] Vec extent() const { return max - min; }

    void grow(const Vec& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void grow(const Box& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    /// Touching counts as intersecting.
    [[nodiscard]] bool intersects(const Box& other) const {
        return glm::all(glm::lessThanEqual(min, other.max))
               && glm::all(glm::lessThanEqual(other.min, max));
    }
    [[nodiscard]] bool contains(const Vec& point) const {
        return glm::all(glm::lessThanEqual(min, point)) && glm::all(glm::lessThanEqual(point, max));
    }
    /// Corner i of 8: bit 0 picks max.x, bit 1 max.y, bit 2 max.z.
    [[nodiscard]] Vec corner(int i) const {
        return {
            (i & 1) != 0 ? max.x : min.x,
            (i & 2) != 0 ? max.y : min.y,
            (i & 4) != 0 ? max.z : min.z};
    }
};

using Aabb = Box<glm::vec3>;       ///< mesh or camera-relative space
using WorldAabb = Box<glm::dvec3>; ///< world space

/// The points with dot(normal, p) + offset >= 0 lie in front.
struct Plane {
    glm::vec3 normal = {0.0F, 1.0F, 0.0F}; ///< unit length
    float offset = 0.0F;

    [[nodiscard]] float distance(const glm::vec3& point) const {
        return glm::dot(normal, point) + offset;
    }
};

/// The convex region in front of five planes: left, right, bottom, top, near. There is no far
/// plane: projections here are infinite.
struct Frustum {
    std::array<Plane, 5> planes;

    /// False only when the box lies wholly behind one plane; conservative at corners.
    [[nodiscard]] bool intersects(const Aabb& box) const;
};

/// The frustum of a projection, in the space that `clip_from_space` starts from.
/// @param clip_from_space reversed infinite depth: clip w > 0 in front, 0 <= z <= w, z = w at the
/// near plane Source: Gribb and Hartmann, "Fast Extraction of Viewing Frustum Planes", 2001.
Frustum frustum_from_clip(const glm::mat4& clip_from_space);

/// The box round a transformed box.
/// @param world_from_mesh affine
/// Source: J. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems, 1990.
WorldAabb transformed(const glm::dmat4& world_from_mesh, const Aabb& box);

/// A box in float coordinates relative to `origin`, grown outward so that rounding loses nothing.
Aabb relative_to(const WorldAabb& box, const glm::dvec3& origin);

} // namespace engine
