// Boxes in the place of a mesh: what is far away may throw its shadow by them.

#pragma once

#include "engine/core/geometry.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace scene {

/// Boxes that hold all triangles of a mesh, mesh space.
struct BoxSet {
    std::vector<engine::Aabb> boxes;
    /// How far the boxes' outline lies outside of the mesh's, in mesh units, the worst of views
    /// along the three axes: the area between the two over the length of the boxes' outline, or a
    /// quarter of how far a place between them is from the mesh where that is more, so that a hole
    /// that is filled does not vanish in the mean. (In the corners of a square round a disc that is
    /// three times the mean.)
    float deviation = 0.0F;
};

/// One box, and up to eight: triangles halved at the median along the longest side, three times.
/// Empty where that saves nothing: boxes take twelve triangles each.
/// @param triangles three indices each
/// Cost: three pictures of 64 x 64 for each set.
std::vector<BoxSet>
make_box_sets(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles);

} // namespace scene
