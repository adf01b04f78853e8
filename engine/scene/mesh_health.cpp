#include "engine/scene/mesh_health.hpp"

#include "engine/core/check.hpp"
#include "engine/core/geometry.hpp"
#include "engine/scene/welded_edges.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <fmt/format.h>
#include <glm/gtx/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>

namespace scene {
namespace {

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// OpenMesh reports every face that it refuses on standard error; we count them instead.
class QuietOpenMesh {
public:
    QuietOpenMesh() { ::omerr().disable(); }
    ~QuietOpenMesh() { ::omerr().enable(); }
    QuietOpenMesh(const QuietOpenMesh&) = delete;
    QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;
};

/// The corners of all triangles with three of them, welded. Those that are merely thin to nothing
/// stay: they close the surface where a vertex lies on the middle of a neighbour's edge.
std::vector<std::uint32_t>
sound_corners(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> welded) {
    std::vector<std::uint32_t> corners;
    corners.reserve(indices.size());
    for (std::size_t first = 0; first < indices.size(); first += 3) {
        const std::uint32_t a = welded[indices[first]];
        const std::uint32_t b = welded[indices[first + 1]];
        const std::uint32_t c = welded[indices[first + 2]];
        if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
    }
    return corners;
}

std::uint32_t count_open_edges(std::span<const std::uint32_t> corners) {
    std::uint32_t count = 0;
    for_each_edge(sides_by_edge(corners), [&count](std::span<const TriangleSide> sides) {
        if (sides.size() == 1) ++count;
    });
    return count;
}

std::uint32_t count_doubled(std::span<const std::uint32_t> corners) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(corners.size() / 3);
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        std::array<std::uint32_t, 3> triangle = {
            corners[first], corners[first + 1], corners[first + 2]};
        std::sort(triangle.begin(), triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    const auto distinct = std::unique(triangles.begin(), triangles.end());
    return static_cast<std::uint32_t>(triangles.end() - distinct);
}

/// The different planes that triangles lie in: normal and offset.
std::vector<glm::dvec4> planes_of(
    std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners, double size) {
    // Planes closer than this, as parts of one and of the mesh's size, count as one.
    constexpr double kSame = 1e-6;
    std::map<std::array<std::int64_t, 4>, glm::dvec4> planes;
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        const glm::dvec3 a(positions[corners[first]]);
        const glm::dvec3 across = glm::cross(
            glm::dvec3(positions[corners[first + 1]]) - a,
            glm::dvec3(positions[corners[first + 2]]) - a);
        const double length = glm::length(across);
        if (length == 0.0) continue;
        const glm::dvec3 normal = across / length;
        const glm::dvec4 plane(normal, glm::dot(normal, a));
        const auto step = [](double value) { return std::llround(value / kSame); };
        planes.try_emplace(
            {step(plane.x), step(plane.y), step(plane.z), step(plane.w / size)}, plane);
    }
    std::vector<glm::dvec4> list;
    for (const auto& [key, plane] : planes)
        list.push_back(plane);
    return list;
}

/// A triangle's unit normal; none of one without an area.
glm::dvec3 normal_of(
    std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners, std::size_t t) {
    const glm::dvec3 a(positions[corners[3 * t]]);
    const glm::dvec3 across = glm::cross(
        glm::dvec3(positions[corners[3 * t + 1]]) - a,
        glm::dvec3(positions[corners[3 * t + 2]]) - a);
    const double length = glm::length(across);
    return length > 0.0 ? across / length : glm::dvec3(0.0);
}

/// Fills in what the silhouette is on average: an edge is in it from as many directions as lie
/// between its triangles, and is seen at pi / 4 of its length. Source: integral geometry, as in
/// Cauchy's formula for the mean projection.
void measure_outline(
    std::span<const glm::vec3> positions,
    std::span<const std::uint32_t> corners,
    std::span<const TriangleSide> sides,
    MeshHealth& health) {
    for_each_edge(sides, [&](std::span<const TriangleSide> of_edge) {
        double share = 1.0; // of all directions; an edge that is no crease between two is always in
        if (of_edge.size() == 2) {
            const glm::dvec3 a = normal_of(positions, corners, of_edge[0].triangle);
            const glm::dvec3 b = normal_of(positions, corners, of_edge[1].triangle);
            const double turn = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            share = turn / std::numbers::pi;
        }
        const glm::dvec3 along =
            glm::dvec3(positions[static_cast<std::uint32_t>(of_edge[0].edge)])
            - glm::dvec3(positions[static_cast<std::uint32_t>(of_edge[0].edge >> 32U)]);
        health.outline_edges += share;
        health.outline += share * glm::length(along) * std::numbers::pi / 4.0;
    });
}

/// No corner lies before the plane of any triangle.
bool is_convex(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners) {
    constexpr double kFlat = 1e-5; // of the mesh's size
    constexpr std::size_t kMostTests = 20'000'000;
    engine::Aabb bounds;
    for (const std::uint32_t corner : corners)
        bounds.grow(positions[corner]);
    const auto size = static_cast<double>(glm::length(bounds.extent()));
    std::vector<std::uint32_t> used(corners.begin(), corners.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const std::vector<glm::dvec4> planes = planes_of(positions, corners, size);
    if (planes.size() * used.size() > kMostTests) return false;
    for (const glm::dvec4& plane : planes)
        for (const std::uint32_t corner : used)
            if (glm::dot(glm::dvec3(plane), glm::dvec3(positions[corner])) > plane.w + kFlat * size)
                return false;
    return true;
}

std::uint32_t
count_refused(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners) {
    const QuietOpenMesh quiet;
    HalfEdgeMesh mesh;
    mesh.reserve(positions.size(), corners.size() / 2, corners.size() / 3);
    for (const glm::vec3& p : positions)
        mesh.add_vertex({p.x, p.y, p.z});
    std::uint32_t refused = 0;
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        const auto vertex = [&](std::size_t k) {
            return OpenMesh::VertexHandle(static_cast<int>(corners[first + k]));
        };
        if (!mesh.add_face(vertex(0), vertex(1), vertex(2)).is_valid()) ++refused;
    }
    return refused;
}

} // namespace

std::vector<std::uint32_t> weld_by_position(std::span<const glm::vec3> positions) {
    std::unordered_map<glm::vec3, std::uint32_t> first_at;
    first_at.reserve(positions.size());
    std::vector<std::uint32_t> welded;
    welded.reserve(positions.size());
    for (const glm::vec3& position : positions) {
        const auto index = static_cast<std::uint32_t>(welded.size());
        welded.push_back(first_at.try_emplace(position, index).first->second);
    }
    return welded;
}

MeshHealth
examine_mesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    CHECK_EQ(indices.size() % 3, std::size_t{0});
    MeshHealth health;
    health.triangles = static_cast<std::uint32_t>(indices.size() / 3);
    health.open_edges_by_index = count_open_edges(indices);

    const std::vector<std::uint32_t> welded = weld_by_position(positions);
    const std::vector<std::uint32_t> corners = sound_corners(indices, welded);
    health.degenerate_triangles = health.triangles - static_cast<std::uint32_t>(corners.size() / 3);
    const std::vector<TriangleSide> all_sides = sides_by_edge(corners);
    for_each_edge(all_sides, [&health](std::span<const TriangleSide> sides) {
        if (sides.size() == 1) ++health.open_edges;
        if (sides.size() > 2) ++health.non_manifold_edges;
        if (sides.size() == 2 && sides[0].rising == sides[1].rising) ++health.flipped_edges;
    });
    measure_outline(positions, corners, all_sides, health);
    health.doubled_triangles = count_doubled(corners);
    health.remainder_triangles = count_refused(positions, corners);
    health.convex = health.closed() && is_convex(positions, corners);
    return health;
}

std::string MeshHealth::summary() const {
    if (triangles == degenerate_triangles) return "empty";
    if (closed()) return "closed";
    std::string text;
    const auto add = [&text](const char* what, std::uint32_t edges) {
        if (edges == 0) return;
        text += fmt::format(
            "{}{} ({} {})", text.empty() ? "" : ", ", what, edges, edges == 1 ? "edge" : "edges");
    };
    add("open", open_edges);
    add("non-manifold", non_manifold_edges);
    add("badly wound", flipped_edges);
    return text;
}

} // namespace scene
