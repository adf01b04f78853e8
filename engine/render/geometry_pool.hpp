// All meshes of a world in two vertex buffers and one index buffer, so that one multi-draw can mix
// them. Positions are a stream of their own: depth-only passes read nothing else. Meshes that
// deform have one range of vertices per entity behind the shared ones, rewritten when their pose
// changes.

#pragma once

#include "engine/gpu/buffer.hpp"
#include "engine/scene/world.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace render {

/// Where a mesh lies in the pool.
struct MeshSlot {
    std::uint32_t first_index = 0; ///< added to Submesh::first_index
    std::int32_t base_vertex = 0;
};

/// Normal, texture coordinates and patch id of one vertex, as the attributes of shared/bindings.h
/// read them.
struct VertexAttributes {
    std::array<std::int16_t, 4> normal = {}; ///< normalised, the fourth is padding
    glm::vec2 uv = {};
    std::uint32_t patch = 0;
};
static_assert(sizeof(VertexAttributes) == 20);

class GeometryPool {
public:
    GeometryPool();

    /// Forgets the meshes and poses of a world; the buffers stay, since draws know them.
    void clear();
    /// Uploads what is new and re-writes poses that changed. Does nothing in a still scene.
    void sync(const scene::World& world);

    [[nodiscard]] MeshSlot slot(std::uint32_t mesh) const { return slots_[mesh]; }
    /// First vertex of an entity whose mesh deforms. @pre it has a PosedMesh
    [[nodiscard]] std::int32_t posed_base_vertex(ecs::Entity entity) const {
        return poses_.at(entity).base_vertex;
    }

    [[nodiscard]] const gpu::Buffer& positions() const { return positions_; }
    [[nodiscard]] const gpu::Buffer& attributes() const { return attributes_; }
    [[nodiscard]] const gpu::Buffer& indices() const { return indices_; }

private:
    struct Pose {
        std::int32_t base_vertex = 0;
        std::uint64_t version = 0; ///< of the PosedMesh that was uploaded; 0 none
    };

    void rebuild(const scene::World& world);
    void upload_pose(const scene::World& world, ecs::Entity entity, Pose& pose);

    gpu::Buffer positions_;
    gpu::Buffer attributes_;
    gpu::Buffer indices_;
    std::vector<MeshSlot> slots_;
    std::unordered_map<ecs::Entity, Pose> poses_;
};

} // namespace render
