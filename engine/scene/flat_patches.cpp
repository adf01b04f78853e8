#include "engine/scene/flat_patches.hpp"

#include "engine/scene/welded_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace scene {
namespace {

constexpr double kLargestResidual = 1e-4; ///< of the diagonal of the mesh's bounds
constexpr double kLeastArea = 0.05;       ///< of the mesh's area
/// Triangles of one patch face the same way: thin sheets keep their two sides apart.
constexpr double kLeastFacing = 0.5;
/// Triangles whose normals differ by less (1.4e-4 radians) grow the same patch, whichever of them
/// is the seed.
constexpr double kParallel = 1.0 - 1e-8;

/// A small seed is tilted by its rounding; the mean planes of what it grew are not. Each growth is
/// held to one plane and contains the seed, so that no number of refits lets a curved surface drift
/// along itself.
constexpr int kRefits = 2;
/// A first growth smaller than this, in least areas, is not worth a refit.
constexpr double kHopeful = 0.25;

struct PlaneFit {
    glm::dvec3 normal = {};
    double offset = 0.0;
};

/// The triangles of a mesh that have an area, with their neighbours across welded edges.
struct Surface {
    std::vector<std::uint32_t> first_index; ///< of each triangle, into Mesh::indices
    std::vector<std::array<glm::dvec3, 3>> corners;
    std::vector<glm::dvec3> normals; ///< unit
    std::vector<double> areas;
    std::vector<std::uint32_t>
        first_neighbour; ///< one per triangle and one past the end, into neighbours
    std::vector<std::uint32_t> neighbours;
    double area = 0.0;
    double size = 0.0; ///< diagonal of the bounds

    [[nodiscard]] std::size_t count() const { return areas.size(); }
};

struct Region {
    PlaneFit plane;
    std::vector<std::uint32_t> triangles;
    double area = 0.0;
    double residual = 0.0;
};

void link_neighbours(Surface& surface, std::span<const std::uint32_t> welded_corners) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
    for_each_edge(sides_by_edge(welded_corners), [&links](std::span<const TriangleSide> sides) {
        // A chain through the sides of an edge connects them all, however many there are.
        for (std::size_t k = 1; k < sides.size(); ++k) {
            links.emplace_back(sides[k - 1].triangle, sides[k].triangle);
            links.emplace_back(sides[k].triangle, sides[k - 1].triangle);
        }
    });
    std::sort(links.begin(), links.end());
    surface.first_neighbour.assign(surface.count() + 1, 0);
    for (const auto& link : links)
        ++surface.first_neighbour[link.first + 1];
    std::partial_sum(
        surface.first_neighbour.begin(),
        surface.first_neighbour.end(),
        surface.first_neighbour.begin());
    for (const auto& link : links)
        surface.neighbours.push_back(link.second);
}

Surface surface_of(const Mesh& mesh) {
    Surface surface;
    const std::vector<std::uint32_t> welded = weld_by_position(mesh.positions);
    std::vector<std::uint32_t> welded_corners;
    engine::Box<glm::dvec3> bounds;
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.topology != Topology::triangles) continue;
        for (std::uint32_t first = submesh.first_index;
             first < submesh.first_index + submesh.index_count;
             first += 3) {
            std::array<glm::dvec3, 3> corners;
            for (std::uint32_t k = 0; k < 3; ++k) {
                corners[k] = mesh.positions[mesh.indices[first + k]];
                bounds.grow(corners[k]);
            }
            const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double length = glm::length(normal);
            if (!(length > 0.0)) continue;
            surface.first_index.push_back(first);
            surface.corners.push_back(corners);
            surface.normals.push_back(normal / length);
            surface.areas.push_back(length / 2.0);
            surface.area += length / 2.0;
            for (std::uint32_t k = 0; k < 3; ++k)
                welded_corners.push_back(welded[mesh.indices[first + k]]);
        }
    }
    if (!bounds.empty()) surface.size = glm::length(bounds.extent());
    link_neighbours(surface, welded_corners);
    return surface;
}

/// The farthest corner of a triangle from a plane.
double distance(const Surface& surface, std::uint32_t triangle, const PlaneFit& plane) {
    double farthest = 0.0;
    for (const glm::dvec3& corner : surface.corners[triangle])
        farthest = std::max(farthest, std::abs(glm::dot(plane.normal, corner) - plane.offset));
    return farthest;
}

/// All triangles connected to the seed that lie in the plane; empty when the seed itself does not.
/// @param taken triangles that belong to a patch already
Region grow(
    const Surface& surface,
    std::uint32_t seed,
    const PlaneFit& plane,
    const std::vector<bool>& taken,
    std::vector<std::uint32_t>& seen,
    std::uint32_t mark) {
    Region region;
    region.plane = plane;
    std::vector<std::uint32_t> open = {seed};
    seen[seed] = mark;
    while (!open.empty()) {
        const std::uint32_t triangle = open.back();
        open.pop_back();
        const double residual = distance(surface, triangle, plane);
        if (residual > kLargestResidual * surface.size
            || glm::dot(surface.normals[triangle], plane.normal) < kLeastFacing)
            continue;
        region.triangles.push_back(triangle);
        region.area += surface.areas[triangle];
        region.residual = std::max(region.residual, residual);
        for (std::uint32_t k = surface.first_neighbour[triangle];
             k < surface.first_neighbour[triangle + 1];
             ++k) {
            const std::uint32_t next = surface.neighbours[k];
            if (taken[next] || seen[next] == mark) continue;
            seen[next] = mark;
            open.push_back(next);
        }
    }
    return region;
}

/// The mean plane of a region, every triangle by its area.
PlaneFit mean_plane(const Surface& surface, const Region& region) {
    glm::dvec3 normal(0.0);
    glm::dvec3 centre(0.0);
    for (const std::uint32_t triangle : region.triangles) {
        const auto& corners = surface.corners[triangle];
        normal += surface.areas[triangle] * surface.normals[triangle];
        centre += surface.areas[triangle] / 3.0 * (corners[0] + corners[1] + corners[2]);
    }
    normal = glm::normalize(normal);
    return {normal, glm::dot(normal, centre / region.area)};
}

/// Large triangles first: their planes are the best known, and they are the likeliest parts of a
/// patch.
std::vector<Region> find_regions(const Surface& surface) {
    std::vector<std::uint32_t> seeds(surface.count());
    std::iota(seeds.begin(), seeds.end(), 0U);
    std::stable_sort(seeds.begin(), seeds.end(), [&surface](std::uint32_t a, std::uint32_t b) {
        return surface.areas[a] > surface.areas[b];
    });

    std::vector<Region> regions;
    std::vector<bool> taken(surface.count());
    std::vector<bool> tried(surface.count());
    std::vector<std::uint32_t> seen(surface.count(), 0);
    std::uint32_t mark = 0;
    const double least_area = kLeastArea * surface.area;
    for (const std::uint32_t seed : seeds) {
        if (taken[seed] || tried[seed]) continue;
        const glm::dvec3& normal = surface.normals[seed];
        PlaneFit plane = {normal, glm::dot(normal, surface.corners[seed][0])};
        Region region = grow(surface, seed, plane, taken, seen, ++mark);
        for (int refit = 0; refit < kRefits && region.area > kHopeful * least_area; ++refit) {
            plane = mean_plane(surface, region);
            region = grow(surface, seed, plane, taken, seen, ++mark);
        }
        const bool large = region.area >= least_area;
        for (const std::uint32_t triangle : region.triangles) {
            if (large)
                taken[triangle] = true;
            else if (glm::dot(surface.normals[triangle], normal) > kParallel)
                tried[triangle] = true;
        }
        if (large) regions.push_back(std::move(region));
    }
    std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) {
        return a.area > b.area;
    });
    if (regions.size() > kMaxPatches) regions.resize(kMaxPatches);
    return regions;
}

FlatPatch patch_of(const Surface& surface, const Region& region) {
    FlatPatch patch;
    patch.normal = glm::vec3(region.plane.normal);
    patch.offset = static_cast<float>(region.plane.offset);
    patch.residual = static_cast<float>(region.residual);
    patch.area = static_cast<float>(region.area);
    for (const std::uint32_t triangle : region.triangles)
        for (const glm::dvec3& corner : surface.corners[triangle])
            patch.bounds.grow(glm::vec3(corner));
    return patch;
}

/// Gives every vertex the patch of the index that uses it first, and a copy of itself to each other
/// patch.
void assign_vertices(Mesh& mesh, std::span<const std::uint8_t> patch_of_index) {
    std::vector<bool> used(mesh.positions.size());
    std::map<std::pair<std::uint32_t, std::uint8_t>, std::uint32_t> copies;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t vertex = mesh.indices[i];
        const std::uint8_t patch = patch_of_index[i];
        if (!used[vertex]) {
            used[vertex] = true;
            mesh.patch_ids[vertex] = patch;
        }
        if (mesh.patch_ids[vertex] == patch) continue;
        const auto [copy, added] =
            copies.try_emplace({vertex, patch}, static_cast<std::uint32_t>(mesh.positions.size()));
        if (added) {
            mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
            mesh.normals.push_back(glm::vec3(mesh.normals[vertex]));
            if (!mesh.uvs.empty()) mesh.uvs.push_back(glm::vec2(mesh.uvs[vertex]));
            mesh.patch_ids.push_back(patch);
        }
        mesh.indices[i] = copy->second;
    }
}

} // namespace

void split_flat_patches(Mesh& mesh) {
    mesh.patches.clear();
    mesh.has_rest = true;
    mesh.patch_ids.assign(mesh.positions.size(), 0);
    if (mesh.deforms()) return;

    const Surface surface = surface_of(mesh);
    const std::vector<Region> regions = find_regions(surface);
    std::vector<std::uint8_t> patch_of_index(mesh.indices.size(), 0);
    for (const Region& region : regions) {
        mesh.patches.push_back(patch_of(surface, region));
        const auto id = static_cast<std::uint8_t>(mesh.patches.size());
        for (const std::uint32_t triangle : region.triangles)
            std::fill_n(patch_of_index.begin() + surface.first_index[triangle], 3, id);
    }
    mesh.has_rest =
        std::find(patch_of_index.begin(), patch_of_index.end(), 0) != patch_of_index.end();
    assign_vertices(mesh, patch_of_index);
}

} // namespace scene
