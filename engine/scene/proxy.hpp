// Simpler stand-ins for a closed mesh where only its shadow counts. OpenMesh's decimater collapses
// edges into one of their ends, so a proxy is a list of indices over the mesh's own vertices:
// nothing new has to be stored, placed or uploaded, and it never leaves their convex hull. How far
// it is from the mesh is measured and kept, so that the error of using it can be told beforehand.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scene {

struct Mesh;

/// How many there can be of a mesh, each with at most half the triangles of the one before.
inline constexpr std::size_t kProxyLevels = 3;

struct Proxy {
    std::vector<std::uint32_t> corners; ///< three vertices of the mesh per triangle; closed
    /// No point of either surface is farther from the other one; in mesh units. Measured at every
    /// corner and at points between them, about as dense as the mesh's own corners, and kept a
    /// tenth larger: what lies between samples is less than that away (tested).
    float deviation = 0.0F;

    [[nodiscard]] std::uint32_t triangle_count() const {
        return static_cast<std::uint32_t>(corners.size() / 3);
    }
};

/// Coarser and coarser; fewer than kProxyLevels where the mesh does not give more, none for one
/// that deforms (the deviation of a pose is not known), is not closed, or is small already.
/// Cost: about 30 us per triangle of the mesh; once, when a hero is loaded.
/// Source: M. Garland and P. Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997,
/// as OpenMesh has it.
std::vector<Proxy> make_proxies(const Mesh& mesh);

/// A mesh that is nothing but a proxy's triangles, for whoever reads meshes.
Mesh as_mesh(const Mesh& mesh, const Proxy& proxy);

} // namespace scene
