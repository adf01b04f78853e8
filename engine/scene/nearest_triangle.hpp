// How far a point is from a surface: the nearest of many triangles, found in a tree of boxes.

#pragma once

#include "engine/core/geometry.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace scene {

/// The point of a triangle that is nearest to `p`; right for triangles without area, too.
/// Source: C. Ericson, "Real-Time Collision Detection", 2004, 5.1.5.
glm::dvec3 nearest_on_triangle(
    const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

class NearestTriangle {
public:
    /// Keeps views of both; the caller keeps them alive.
    /// @param corners three vertices per triangle, at least one triangle
    NearestTriangle(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners);

    /// From `point` to the surface. Cost: about a microsecond.
    [[nodiscard]] double distance(const glm::dvec3& point) const;

private:
    struct Node {
        engine::Aabb box;
        std::uint32_t first = 0; ///< of its triangles in order_, or its first child; children are
                                 ///< next to each other
        std::uint32_t count = 0; ///< of triangles; 0: it has children
    };

    void split(std::size_t node);
    [[nodiscard]] glm::dvec3 corner(std::uint32_t triangle, std::size_t k) const;
    [[nodiscard]] glm::dvec3 middle(std::uint32_t triangle) const;

    std::span<const glm::vec3> positions_;
    std::span<const std::uint32_t> corners_;
    std::vector<std::uint32_t> order_; ///< triangles, those of a leaf next to each other
    std::vector<Node> nodes_;          ///< the root first
};

} // namespace scene
