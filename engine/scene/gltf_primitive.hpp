// One glTF primitive on its way to a submesh: indices become lists, and every vertex gets a unit
// normal.

#pragma once

#include "engine/scene/mesh.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace scene {

/// A primitive's vertices and what joins them; arrays are empty or hold one element per vertex.
struct PrimitiveData {
    Topology topology = Topology::triangles;
    std::vector<std::uint32_t> indices; ///< all < positions.size(); a list, as the topology asks
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<JointInfluence> influences;
    std::vector<MorphTarget> morph_targets;
};

/// What the modes of glTF become.
struct ListMode {
    Topology topology;
    std::vector<std::uint32_t> indices;
};

/// Rewrites strips, fans and loops as lists with the winding of the specification; an incomplete
/// last line or triangle is left out.
/// @param mode 0 to 6, as in glTF
/// @return none for other modes
/// Source: glTF 2.0 specification, 3.7.2.1.
std::optional<ListMode> list_indices(int mode, const std::vector<std::uint32_t>& indices);

/// Makes each triangle's corners vertices of their own, with the triangle's normal; morph targets
/// get the difference to their own triangle's normal. Zero-area triangles get +Y.
/// @pre topology is triangles
void make_flat(PrimitiveData& data);

/// Scales normals to length 1 and replaces those that have no direction by the mean of their
/// triangles' normals, weighted by area.
/// @return how many normals were not of length 1 (within 5 %)
std::size_t mend_normals(PrimitiveData& data);

} // namespace scene
