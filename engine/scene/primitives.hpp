// Closed shapes for levels and tests. All are wound counter-clockwise outside, have outward unit
// normals, texture coordinates, and are centred on the origin unless they say otherwise.

#pragma once

#include "engine/scene/mesh.hpp"

namespace scene {

/// @param size full edge lengths; flat shaded: 24 vertices, 12 triangles, 6 patches
Mesh make_box(const glm::vec3& size);
/// One flat quad in the XZ plane facing +Y: open, a receiver only. @param size full edge lengths in
/// x and z
Mesh make_plane(const glm::vec2& size);
/// @param segments round the axis (rings are half of it); at least 3
Mesh make_sphere(float radius, int segments = 48);
/// Along +Y, capped. @param segments at least 3
Mesh make_cylinder(float radius, float height, int segments = 48);
/// Along +Y, the apex up, capped.
Mesh make_cone(float radius, float height, int segments = 48);
/// Round the Y axis. @param radius to the middle of the tube
Mesh make_torus(float radius, float tube_radius, int segments = 64, int tube_segments = 24);

/// Recomputes bounds, health and patches of a mesh made by hand, and gives it one submesh of
/// material 0 when it has none.
void finish_mesh(Mesh& mesh);

} // namespace scene
