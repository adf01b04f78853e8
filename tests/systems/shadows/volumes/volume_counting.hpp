// Counts what a stencil would count, by rays through the triangles of a volume.

#pragma once

#include "systems/shadows/volumes/shadow_volume.hpp"

#include <glm/glm.hpp>

#include <map>
#include <span>
#include <vector>

namespace shadows {

/// A corner of a volume, homogeneous: extruded ones are directions.
inline glm::dvec4
corner_of(std::uint32_t index, std::span<const glm::vec3> positions, const glm::dvec4& light) {
    const glm::dvec3 at(positions[index / 2]);
    if (index % 2 == 0) return {at, 1.0};
    return {at * light.w - glm::dvec3(light), 0.0};
}

/// How many volumes hold a point: faces that a ray from there leaves through less those that it
/// enters by. Source: sides of planes as signs of homogeneous determinants, which hold for points
/// at infinity too.
inline int volumes_round(
    const glm::dvec3& point,
    const glm::dvec3& direction,
    const ShadowVolume& volume,
    std::span<const glm::vec3> positions,
    const glm::dvec4& light) {
    const glm::dvec4 start(point, 1.0);
    const glm::dvec4 way(direction, 0.0);
    const auto side =
        [](const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c, const glm::dvec4& d) {
            return glm::determinant(glm::dmat4(a, b, c, d));
        };
    int count = 0;
    for (std::size_t i = 0; i < volume.indices.size(); i += 3) {
        const glm::dvec4 a = corner_of(volume.indices[i], positions, light);
        glm::dvec4 b = corner_of(volume.indices[i + 1], positions, light);
        glm::dvec4 c = corner_of(volume.indices[i + 2], positions, light);
        if (i >= volume.near_end) std::swap(b, c);
        const double ab = side(start, way, a, b);
        const double bc = side(start, way, b, c);
        const double ca = side(start, way, c, a);
        if (!((ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0))) continue;
        // The line meets the triangle: ahead of the start when start and way are on different sides
        // of it. A triangle at infinity is met where it holds the way itself, not the way back.
        const double before = side(a, b, c, start);
        if (a.w == 0.0 && b.w == 0.0 && c.w == 0.0) {
            const glm::dmat3 corners{glm::dvec3(a), glm::dvec3(b), glm::dvec3(c)};
            const glm::dmat3 with_way{direction, glm::dvec3(b), glm::dvec3(c)};
            if (glm::determinant(corners) * glm::determinant(with_way) < 0.0) continue;
        } else if (before * side(a, b, c, way) > 0.0) {
            continue;
        }
        count += before > 0.0 ? 1 : -1;
    }
    return count;
}

/// How often each directed edge is run, less how often the other way round: all zero on a closed
/// surface.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, int>
unmatched_edges(const ShadowVolume& volume, std::span<const std::uint32_t> same_place, bool sun) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto place = [&](std::uint32_t index) {
        if (sun && index % 2 == 1) return 1U; // one point
        return 2 * same_place[index / 2] + index % 2;
    };
    for (std::size_t i = 0; i < volume.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t from = place(volume.indices[i + k]);
            std::uint32_t to = place(volume.indices[i + (k + 1) % 3]);
            if (i >= volume.near_end) std::swap(from, to);
            if (from == to) continue;
            edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
    return edges;
}

} // namespace shadows
