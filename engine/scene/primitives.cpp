#include "engine/scene/primitives.hpp"

#include "engine/core/check.hpp"
#include "engine/scene/flat_patches.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scene {
namespace {

/// Cosine and sine of index / count of a whole turn. Index `count` is exactly index 0, so that
/// seams weld.
glm::vec2 on_circle(double index, int count) {
    const double angle = glm::two_pi<double>() * std::fmod(index, count) / count;
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

std::uint32_t
add_vertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back(uv);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// A rectangle round `centre`; it faces along cross(half_u, half_v).
void add_quad(
    Mesh& mesh, const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v) {
    const glm::vec3 normal = glm::normalize(glm::cross(half_u, half_v));
    const auto first = add_vertex(mesh, centre - half_u - half_v, normal, {0.0F, 1.0F});
    add_vertex(mesh, centre + half_u - half_v, normal, {1.0F, 1.0F});
    add_vertex(mesh, centre + half_u + half_v, normal, {1.0F, 0.0F});
    add_vertex(mesh, centre - half_u + half_v, normal, {0.0F, 0.0F});
    add_triangle(mesh, first, first + 1, first + 2);
    add_triangle(mesh, first, first + 2, first + 3);
}

/// A point of a profile, and the normal there, both as (away from the axis, up).
struct ProfilePoint {
    glm::vec2 position;
    glm::vec2 normal; ///< unit length
};

/// Turns a profile round the Y axis. Where the profile touches the axis, each segment ends in one
/// triangle with a vertex of its own.
/// @param profile runs counter-clockwise round the solid: up along its outside
void add_lathe(Mesh& mesh, const std::vector<ProfilePoint>& profile, int segments) {
    CHECK_GE(segments, 3);
    const auto stride = static_cast<std::uint32_t>(segments) + 1;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t row = 0; row < profile.size(); ++row) {
        const auto [position, normal] = profile[row];
        const float v = 1.0F - static_cast<float>(row) / static_cast<float>(profile.size() - 1);
        for (int i = 0; i <= segments; ++i) {
            const double turn =
                position.x == 0.0F ? i + 0.5 : i; // the middle of a segment's only triangle
            const glm::vec2 c = on_circle(turn, segments);
            add_vertex(
                mesh,
                {position.x * c.x, position.y, -position.x * c.y},
                {normal.x * c.x, normal.y, -normal.x * c.y},
                {static_cast<float>(turn / segments), v});
        }
    }
    for (std::uint32_t row = 0; row + 1 < profile.size(); ++row)
        for (std::uint32_t a = first + row * stride; a + 1 < first + (row + 1) * stride; ++a) {
            const std::uint32_t b = a + stride;
            if (profile[row].position.x == 0.0F) {
                add_triangle(mesh, a, b + 1, b);
            } else if (profile[row + 1].position.x == 0.0F) {
                add_triangle(mesh, a, a + 1, b);
            } else {
                add_triangle(mesh, a, a + 1, b + 1);
                add_triangle(mesh, a, b + 1, b);
            }
        }
}

void add_bottom(Mesh& mesh, float radius, float y, int segments) {
    add_lathe(mesh, {{{0.0F, y}, {0.0F, -1.0F}}, {{radius, y}, {0.0F, -1.0F}}}, segments);
}

} // namespace

Mesh make_box(const glm::vec3& size) {
    Mesh mesh;
    mesh.name = "box";
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {0.5F, -0.5F}) {
            const int next = (axis + 1) % 3;
            const int last = (axis + 2) % 3;
            glm::vec3 centre(0.0F);
            glm::vec3 half_u(0.0F);
            glm::vec3 half_v(0.0F);
            centre[axis] = side * size[axis];
            half_u[next] = side * size[next];
            half_v[last] = 0.5F * size[last];
            add_quad(mesh, centre, half_u, half_v);
        }
    finish_mesh(mesh);
    return mesh;
}

Mesh make_plane(const glm::vec2& size) {
    Mesh mesh;
    mesh.name = "plane";
    add_quad(mesh, glm::vec3(0.0F), {0.5F * size.x, 0.0F, 0.0F}, {0.0F, 0.0F, -0.5F * size.y});
    finish_mesh(mesh);
    return mesh;
}

Mesh make_sphere(float radius, int segments) {
    Mesh mesh;
    mesh.name = "sphere";
    const int rings = std::max(2, segments / 2);
    std::vector<ProfilePoint> profile = {{{0.0F, -radius}, {0.0F, -1.0F}}};
    for (int ring = 1; ring < rings; ++ring) {
        const glm::vec2 c = on_circle(ring, 2 * rings);
        profile.push_back({{radius * c.y, -radius * c.x}, {c.y, -c.x}});
    }
    profile.push_back({{0.0F, radius}, {0.0F, 1.0F}});
    add_lathe(mesh, profile, segments);
    finish_mesh(mesh);
    return mesh;
}

Mesh make_cylinder(float radius, float height, int segments) {
    Mesh mesh;
    mesh.name = "cylinder";
    const float top = 0.5F * height;
    add_bottom(mesh, radius, -top, segments);
    add_lathe(mesh, {{{radius, -top}, {1.0F, 0.0F}}, {{radius, top}, {1.0F, 0.0F}}}, segments);
    add_lathe(mesh, {{{radius, top}, {0.0F, 1.0F}}, {{0.0F, top}, {0.0F, 1.0F}}}, segments);
    finish_mesh(mesh);
    return mesh;
}

Mesh make_cone(float radius, float height, int segments) {
    Mesh mesh;
    mesh.name = "cone";
    const float top = 0.5F * height;
    const glm::vec2 normal = glm::normalize(glm::vec2(height, radius));
    add_bottom(mesh, radius, -top, segments);
    add_lathe(mesh, {{{radius, -top}, normal}, {{0.0F, top}, normal}}, segments);
    finish_mesh(mesh);
    return mesh;
}

Mesh make_torus(float radius, float tube_radius, int segments, int tube_segments) {
    CHECK_GE(tube_segments, 3);
    CHECK_GT(radius, tube_radius);
    Mesh mesh;
    mesh.name = "torus";
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= tube_segments; ++i) {
        const glm::vec2 c = on_circle(i, tube_segments);
        profile.push_back({glm::vec2(radius, 0.0F) + tube_radius * c, c});
    }
    add_lathe(mesh, profile, segments);
    finish_mesh(mesh);
    return mesh;
}

void finish_mesh(Mesh& mesh) {
    if (mesh.submeshes.empty())
        mesh.submeshes.push_back(
            {Topology::triangles, 0, static_cast<std::uint32_t>(mesh.indices.size()), 0});
    mesh.bounds = {};
    for (const std::uint32_t index : mesh.indices)
        mesh.bounds.grow(mesh.positions[index]);

    std::vector<std::uint32_t> triangles;
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.topology != Topology::triangles) continue;
        const auto first = mesh.indices.begin() + submesh.first_index;
        triangles.insert(triangles.end(), first, first + submesh.index_count);
    }
    // Health first: patches duplicate vertices along their borders, which no file asked for.
    mesh.health = examine_mesh(mesh.positions, triangles);
    split_flat_patches(mesh);
    mesh.box_sets.clear();
    if (!mesh.deforms()) mesh.box_sets = make_box_sets(mesh.positions, triangles);
}

} // namespace scene
