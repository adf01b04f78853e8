// A mesh as every part of the engine sees it: triangles in mesh space, what they are made of, and
// what was found wrong with them. One glTF mesh is one Mesh; its primitives are submeshes.

#pragma once

#include "engine/core/geometry.hpp"
#include "engine/scene/box_set.hpp"
#include "engine/scene/mesh_health.hpp"
#include "engine/scene/proxy.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scene {

/// What the indices of a submesh mean. Strips, fans and loops are rewritten as lists at load.
enum class Topology : std::uint8_t { triangles, lines, points };

/// A run of indices with one material.
struct Submesh {
    Topology topology = Topology::triangles;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0; ///< a multiple of 3, 2 or 1, as the topology asks
    std::uint32_t material =
        0; ///< index into Assets::materials (Model::materials before it is added)
};

/// A connected coplanar part of a mesh, mesh space: dot(normal, p) = offset for its points.
/// Only meshes that do not change shape have patches.
struct FlatPatch {
    glm::vec3 normal = {0.0F, 1.0F, 0.0F}; ///< unit length, outward by the winding
    float offset = 0.0F;
    float residual = 0.0F; ///< largest distance of a vertex from the plane, in mesh units
    float area = 0.0F;     ///< in square mesh units
    engine::Aabb bounds;
};

/// Up to four joints that move a vertex; weights add up to 1.
struct JointInfluence {
    std::array<std::uint16_t, 4> joints = {};
    glm::vec4 weights = {1.0F, 0.0F, 0.0F, 0.0F};
};

/// Offsets of every vertex of the mesh at weight 1.
struct MorphTarget {
    std::vector<glm::vec3> position_deltas; ///< one per vertex
    std::vector<glm::vec3> normal_deltas;   ///< one per vertex, or empty
};

/// Limits of a mesh: patches a mesh may have, besides "the rest".
inline constexpr int kMaxPatches = 16;

struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;    ///< finite
    std::vector<glm::vec3> normals;      ///< unit length, one per vertex
    std::vector<glm::vec2> uvs;          ///< one per vertex, or empty
    std::vector<std::uint8_t> patch_ids; ///< one per vertex: 0 is "the rest", k is patches[k - 1];
                                         ///< constant over each triangle
    std::vector<std::uint32_t> indices;  ///< all < positions.size()
    std::vector<Submesh> submeshes;
    std::vector<JointInfluence> influences; ///< one per vertex when the mesh is skinned, else empty
    std::vector<MorphTarget> morph_targets;
    std::vector<float> morph_weights; ///< defaults, one per target
    engine::Aabb bounds;              ///< of the positions that indices use
    std::vector<FlatPatch> patches;   ///< at most kMaxPatches
    bool has_rest = true;             ///< some of the mesh lies in no patch
    MeshHealth health;                ///< of all triangles together
    std::vector<Proxy> proxies;       ///< of heroes, coarser and coarser; see make_proxies()
    std::vector<BoxSet> box_sets;     ///< coarsest first; none where it deforms

    [[nodiscard]] bool deforms() const { return !influences.empty() || !morph_targets.empty(); }
};

} // namespace scene
