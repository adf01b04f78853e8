#include "engine/scene/proxy.hpp"

#include "engine/scene/mesh.hpp"
#include "engine/scene/nearest_triangle.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace scene {

namespace {

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Decimater = OpenMesh::Decimater::DecimaterT<HalfEdgeMesh>;

/// A mesh with fewer triangles casts cheaply enough.
constexpr std::uint32_t kFewTriangles = 256;
/// What a level has of the triangles of the one before, and what it must not have more of.
constexpr double kShare = 0.25;
constexpr double kWorstShare = 0.5;
/// Triangles do not turn farther in one collapse, degrees.
constexpr float kMostTurn = 60.0F;
/// Deviations are kept so much larger than they were measured.
constexpr double kSafety = 1.1;
/// Measured points per side of a triangle, at most.
constexpr int kMostSteps = 32;

/// The mesh's triangles between welded vertices, those without three corners left out.
std::vector<std::uint32_t> welded_corners(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weld_by_position(mesh.positions);
    std::vector<std::uint32_t> corners;
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.topology != Topology::triangles) continue;
        for (std::uint32_t i = 0; i < submesh.index_count; i += 3) {
            const std::uint32_t* indices = &mesh.indices[submesh.first_index + i];
            const std::uint32_t a = welded[indices[0]];
            const std::uint32_t b = welded[indices[1]];
            const std::uint32_t c = welded[indices[2]];
            if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
        }
    }
    return corners;
}

/// Half-edges that know the vertices of the mesh that they were made from.
class Collapsing {
public:
    Collapsing(const Mesh& mesh, std::span<const std::uint32_t> corners) {
        halfedges_.request_vertex_status();
        halfedges_.request_edge_status();
        halfedges_.request_face_status();
        std::unordered_map<std::uint32_t, OpenMesh::VertexHandle> handles;
        const auto handle = [&](std::uint32_t vertex) {
            const auto [found, is_new] = handles.try_emplace(vertex);
            if (is_new) {
                const glm::vec3& p = mesh.positions[vertex];
                found->second = halfedges_.add_vertex({p.x, p.y, p.z});
                vertices_.push_back(vertex);
            }
            return found->second;
        };
        for (std::size_t i = 0; i < corners.size(); i += 3)
            halfedges_.add_face(handle(corners[i]), handle(corners[i + 1]), handle(corners[i + 2]));
        left_ = halfedges_.n_faces();
        halfedges_.request_face_normals();
        halfedges_.update_face_normals();
        decimater_.add(quadrics_);
        decimater_.add(turning_);
        decimater_.module(turning_).set_max_normal_deviation(kMostTurn);
        ready_ = decimater_.initialize();
    }

    /// The triangles that are left when there should be no more than `count`.
    std::vector<std::uint32_t> reduce_to(std::size_t count) {
        // The decimater counts from all faces, also those that an earlier call has removed.
        const std::size_t gone = halfedges_.n_faces() - left_;
        if (ready_) decimater_.decimate_to_faces(0, count + gone);
        std::vector<std::uint32_t> corners;
        for (const auto face : halfedges_.faces()) {
            if (face.deleted()) continue;
            for (const auto vertex : face.vertices())
                corners.push_back(vertices_[static_cast<std::size_t>(vertex.idx())]);
        }
        left_ = corners.size() / 3;
        return corners;
    }

private:
    HalfEdgeMesh halfedges_;
    std::vector<std::uint32_t> vertices_; ///< of the mesh, by handle
    Decimater decimater_{halfedges_};
    OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>::Handle quadrics_;
    OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle turning_;
    std::size_t left_ = 0; ///< faces that are not removed
    bool ready_ = false;
};

/// The farthest that a point of a closed surface was found from another one.
/// @param spacing of the points, mesh units
double farthest(
    std::span<const glm::vec3> positions,
    std::span<const std::uint32_t> corners,
    const NearestTriangle& surface,
    double spacing) {
    double most = 0.0;
    std::vector<bool> tried(positions.size(), false);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        // Of a closed surface each edge is run once each way: its points are tried going up.
        const bool ab_up = corners[i] < corners[i + 1];
        const bool bc_up = corners[i + 1] < corners[i + 2];
        const bool ca_up = corners[i + 2] < corners[i];
        const glm::dvec3 a(positions[corners[i]]);
        const glm::dvec3 ab = glm::dvec3(positions[corners[i + 1]]) - a;
        const glm::dvec3 ac = glm::dvec3(positions[corners[i + 2]]) - a;
        const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
        const int steps = static_cast<int>(
            std::clamp(std::ceil(longest / spacing), 2.0, static_cast<double>(kMostSteps)));
        for (std::size_t k = 0; k < 3; ++k) {
            if (tried[corners[i + k]]) continue;
            tried[corners[i + k]] = true;
            most = std::max(most, surface.distance(positions[corners[i + k]]));
        }
        for (int u = 0; u <= steps; ++u)
            for (int v = 0; u + v <= steps; ++v) {
                const int w = steps - u - v;
                if (u == steps || v == steps || w == steps) continue; // a corner
                if ((v == 0 && !ab_up) || (w == 0 && !bc_up) || (u == 0 && !ca_up)) continue;
                const glm::dvec3 point = a + ab * (static_cast<double>(u) / steps)
                                         + ac * (static_cast<double>(v) / steps);
                most = std::max(most, surface.distance(point));
            }
    }
    return most;
}

/// As if every triangle were as large as all others.
double mean_side(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners) {
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 a(positions[corners[i]]);
        area += 0.5
                * glm::length(glm::cross(
                    glm::dvec3(positions[corners[i + 1]]) - a,
                    glm::dvec3(positions[corners[i + 2]]) - a));
    }
    return std::sqrt(2.0 * area / (static_cast<double>(corners.size()) / 3.0));
}

} // namespace

std::vector<Proxy> make_proxies(const Mesh& mesh) {
    std::vector<Proxy> proxies;
    const std::vector<std::uint32_t> corners = welded_corners(mesh);
    if (mesh.deforms() || !mesh.health.closed() || mesh.health.remainder_triangles > 0
        || corners.size() / 3 < kFewTriangles)
        return proxies;
    const NearestTriangle whole(mesh.positions, corners);
    const double spacing = mean_side(mesh.positions, corners);
    Collapsing collapsing(mesh, corners);
    std::size_t before = corners.size() / 3;
    while (proxies.size() < kProxyLevels) {
        Proxy proxy;
        proxy.corners =
            collapsing.reduce_to(static_cast<std::size_t>(kShare * static_cast<double>(before)));
        const std::size_t left = proxy.triangle_count();
        if (left < 4 || static_cast<double>(left) > kWorstShare * static_cast<double>(before))
            break;
        const NearestTriangle simple(mesh.positions, proxy.corners);
        const double measured = std::max(
            farthest(mesh.positions, corners, simple, spacing),
            farthest(mesh.positions, proxy.corners, whole, spacing));
        proxy.deviation = static_cast<float>(kSafety * measured);
        proxies.push_back(std::move(proxy));
        before = left;
    }
    return proxies;
}

Mesh as_mesh(const Mesh& mesh, const Proxy& proxy) {
    Mesh simple;
    simple.name = mesh.name;
    simple.positions = mesh.positions;
    simple.indices = proxy.corners;
    simple.submeshes.push_back(
        {Topology::triangles, 0, static_cast<std::uint32_t>(proxy.corners.size()), 0});
    simple.bounds = mesh.bounds;
    return simple;
}

} // namespace scene
