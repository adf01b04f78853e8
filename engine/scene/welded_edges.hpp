// The edges of a triangle list after vertices at equal positions became one: what counting edges
// and walking from triangle to triangle have in common.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scene {

/// One side of one triangle.
struct TriangleSide {
    std::uint64_t edge = 0;     ///< lower vertex in the high half, upper vertex in the low half
    std::uint32_t triangle = 0; ///< index of the triangle in the list
    bool rising = true;         ///< the triangle runs the edge from its lower to its upper vertex
};

/// The sides of all triangles, those of one edge next to each other, triangles rising within an
/// edge. Sides between equal vertices are left out.
/// @param corners three vertices per triangle, welded already
inline std::vector<TriangleSide> sides_by_edge(std::span<const std::uint32_t> corners) {
    std::vector<TriangleSide> sides;
    sides.reserve(corners.size());
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t from = corners[first + k];
            const std::uint64_t to = corners[first + (k + 1) % 3];
            if (from == to) continue;
            sides.push_back(
                {(std::min(from, to) << 32U) | std::max(from, to),
                 static_cast<std::uint32_t>(first / 3),
                 from < to});
        }
    std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
    });
    return sides;
}

/// Calls `visit(std::span<const TriangleSide>)` once for every edge.
template <class Visit>
void for_each_edge(std::span<const TriangleSide> sides, Visit visit) {
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t end = first + 1;
        while (end < sides.size() && sides[end].edge == sides[first].edge)
            ++end;
        visit(sides.subspan(first, end - first));
        first = end;
    }
}

} // namespace scene
