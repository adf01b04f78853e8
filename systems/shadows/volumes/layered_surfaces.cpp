#include "systems/shadows/volumes/layered_surfaces.hpp"

#include "engine/scene/mesh_health.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace shadows {

namespace {

bool is_open(const CasterSurface& surface) {
    const auto not_zero = [](auto value) { return value != 0; };
    return std::any_of(surface.turned.begin(), surface.turned.end(), not_zero)
           || std::any_of(surface.dark_weight.begin(), surface.dark_weight.end(), not_zero);
}

LayeredSurface layered(const scene::Mesh& mesh, const Remedies& remedies) {
    LayeredSurface made{make_caster_surface(mesh, remedies)};
    made.open = is_open(made.surface);
    made.layers = count_layers(made.surface, mesh.positions);
    return made;
}

/// A triangle of a mesh, and the part that it hangs together with.
struct PartTriangle {
    std::uint32_t part = 0;
    std::array<std::uint32_t, 3> corners = {};
};

/// All triangles, part after part. Source: union and find over welded vertices.
std::vector<PartTriangle> triangles_by_part(const scene::Mesh& mesh) {
    const std::vector<std::uint32_t> welded = scene::weld_by_position(mesh.positions);
    std::vector<std::uint32_t> parent(mesh.positions.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t vertex) {
        while (parent[vertex] != vertex)
            vertex = parent[vertex] = parent[parent[vertex]];
        return vertex;
    };
    std::vector<PartTriangle> triangles;
    for (const scene::Submesh& submesh : mesh.submeshes) {
        if (submesh.topology != scene::Topology::triangles) continue;
        for (std::uint32_t i = 0; i < submesh.index_count; i += 3) {
            PartTriangle triangle;
            for (std::uint32_t k = 0; k < 3; ++k)
                triangle.corners[k] = mesh.indices[submesh.first_index + i + k];
            for (const std::uint32_t corner : triangle.corners)
                parent[root(welded[corner])] = root(welded[triangle.corners[0]]);
            triangles.push_back(triangle);
        }
    }
    for (PartTriangle& triangle : triangles)
        triangle.part = root(welded[triangle.corners[0]]);
    std::stable_sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
        return a.part < b.part;
    });
    return triangles;
}

/// Where to halve: between two parts, as near to the middle as there is such a place.
std::size_t halfway(std::span<const PartTriangle> triangles) {
    const std::size_t middle = triangles.size() / 2;
    for (std::size_t away = 0; away < middle; ++away)
        for (const std::size_t place : {middle - away, middle + away})
            if (place < triangles.size() && triangles[place - 1].part != triangles[place].part)
                return place;
    return middle;
}

void add_pieces(
    scene::Mesh& piece,
    std::span<const PartTriangle> triangles,
    const Remedies& remedies,
    std::vector<LayeredSurface>& pieces) {
    piece.indices.clear();
    for (const PartTriangle& triangle : triangles)
        piece.indices.insert(piece.indices.end(), triangle.corners.begin(), triangle.corners.end());
    piece.submeshes = {
        {scene::Topology::triangles, 0, static_cast<std::uint32_t>(piece.indices.size()), 0}};
    LayeredSurface made = layered(piece, remedies);
    if (made.layers <= kMostLayers) {
        pieces.push_back(std::move(made));
        return;
    }
    const std::size_t half = halfway(triangles);
    add_pieces(piece, triangles.first(half), remedies, pieces);
    add_pieces(piece, triangles.subspan(half), remedies, pieces);
}

} // namespace

std::vector<LayeredSurface>
make_layered_surfaces(const scene::Mesh& mesh, const Remedies& remedies) {
    std::vector<LayeredSurface> pieces;
    LayeredSurface whole = layered(mesh, remedies);
    if (whole.surface.corners.empty()) return pieces;
    if (whole.layers <= kMostLayers || !remedies.on(Remedy::volume_batches)) {
        pieces.push_back(std::move(whole));
        return pieces;
    }
    scene::Mesh piece = mesh; // with what moves its vertices
    const std::vector<PartTriangle> triangles = triangles_by_part(mesh);
    add_pieces(piece, triangles, remedies, pieces);
    return pieces;
}

} // namespace shadows
