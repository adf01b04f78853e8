// The triangles of one entity as rays meet them: posed, in the world, in double precision. The tree
// that finds candidates works in floats; what it finds is decided here.

#pragma once

#include "ecs/entity.hpp"
#include "engine/core/geometry.hpp"
#include "engine/scene/world.hpp"
#include "engine/trace/alpha_mask.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace trace {

inline constexpr std::uint32_t kNoMask = 0xFFFFFFFFU;

struct ExactTriangle {
    std::array<std::uint32_t, 3> corners = {}; ///< into ExactGeometry::positions
    std::uint32_t first_index = 0;             ///< of its corners in Mesh::indices
    std::uint32_t mask_corner =
        kNoMask;            ///< of its first corner in ExactGeometry::uvs; kNoMask: no holes
    std::uint16_t mask = 0; ///< into ExactGeometry::masks
    std::uint8_t patch_id = 0;
    bool double_sided = false;
};

/// Where a ray meets a triangle.
struct Crossing {
    double t = 0.0;
    double u = 0.0; ///< weight of the second corner
    double v = 0.0; ///< weight of the third corner
};

struct ExactGeometry {
    ecs::Entity entity;
    bool casts = true;
    bool receives = true;
    bool mirrored = false;             ///< the transform turns the winding round
    std::vector<glm::dvec3> positions; ///< world, relative to the scene's origin
    std::vector<ExactTriangle> triangles;
    std::vector<glm::vec2> uvs; ///< three per triangle that may have holes
    std::vector<AlphaMask> masks;
    engine::Box<glm::dvec3> bounds; ///< relative to the scene's origin

    [[nodiscard]] engine::Box<glm::dvec3> triangle_bounds(std::uint32_t triangle) const;
    /// Unit length, outward by the winding as seen in the world.
    [[nodiscard]] glm::dvec3 normal(std::uint32_t triangle) const;
    /// Where the line origin + t * direction meets the triangle, for any t, from either side.
    /// Neighbours overlap by 1e-9 of their size, so that no ray slips between them.
    /// Source: Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
    [[nodiscard]] std::optional<Crossing>
    cross(std::uint32_t triangle, const glm::dvec3& origin, const glm::dvec3& direction) const;
    [[nodiscard]] bool hole_at(std::uint32_t triangle, const Crossing& crossing) const;
};

/// Triangles without area, lines and points are left out.
/// @param origin world position that everything is relative to
/// @pre the entity has a MeshInstance and a WorldTransform
ExactGeometry
exact_geometry(const scene::World& world, ecs::Entity entity, const glm::dvec3& origin);

} // namespace trace
