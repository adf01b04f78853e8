// Obstacles as a walker meets them: what lies between two heights, seen from above.

#pragma once

#include "engine/play/obstacles.hpp"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace play {

/// A convex polygon in plan (x, z), perhaps as thin as a line.
struct PlanShape {
    std::array<glm::dvec2, 5> corners = {};
    int count = 0;

    /// The point of the shape that is nearest to `point`; `point` itself when it is inside.
    [[nodiscard]] glm::dvec2 nearest(const glm::dvec2& point) const;
};

/// The part of a triangle with low < y < high, in plan. Touching does not count.
/// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974.
std::optional<PlanShape> slice(const Triangle& triangle, double low, double high);

/// Height of the triangle's plane over a point of the plan, when the triangle lies over it.
/// Edges overlap by 1e-9 of the triangle, so that no walker falls between neighbours; upright
/// triangles have no height.
std::optional<double> height_at(const Triangle& triangle, const glm::dvec2& point);

} // namespace play
