// What a mesh is fit for as a shadow caster. Real props are mostly open, and no mesh is closed by
// its indices alone, so vertices are first welded by exact position; then edges are counted, and
// OpenMesh builds half-edges from the manifold part while the faces it refuses stay as a remainder.

#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scene {

struct MeshHealth {
    std::uint32_t triangles = 0; ///< as indexed, degenerate ones included
    std::uint32_t degenerate_triangles =
        0; ///< two corners welded together; left out of what follows
    std::uint32_t open_edges_by_index =
        0; ///< edges with one triangle when neighbours are found through indices alone
    std::uint32_t open_edges = 0;         ///< edges with one triangle after the weld
    std::uint32_t non_manifold_edges = 0; ///< edges with more than two triangles
    std::uint32_t flipped_edges = 0;      ///< two triangles that run the edge the same way
    std::uint32_t doubled_triangles =
        0; ///< triangles that share all three corners with an earlier one
    std::uint32_t remainder_triangles = 0; ///< refused by the half-edge structure
    double outline_edges = 0.0; ///< edges of its silhouette, the mean over all directions
    double outline = 0.0; ///< their length as seen, the mean over all directions; in mesh units
    bool convex = false;  ///< closed, and no part of it can darken another; false where that would
                          ///< take too long to find out

    /// Safe for a stencil shadow volume: a surface without edges, holes or contradictions.
    [[nodiscard]] bool closed() const {
        return triangles > degenerate_triangles && open_edges == 0 && non_manifold_edges == 0
               && flipped_edges == 0;
    }
    /// "closed", "open (278 edges)", "non-manifold (19 edges), badly wound (44 edges)" ...
    [[nodiscard]] std::string summary() const;
};

/// Maps every vertex to the first one at exactly the same position (-0 equals 0).
/// Cost: one hash look-up per vertex.
std::vector<std::uint32_t> weld_by_position(std::span<const glm::vec3> positions);

/// @param indices triangle list; all < positions.size()
MeshHealth
examine_mesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

} // namespace scene
