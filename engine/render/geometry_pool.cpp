#include "engine/render/geometry_pool.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace render {

namespace {

std::int16_t snorm16(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767.0F));
}

VertexAttributes
attributes_of(const scene::Mesh& mesh, const glm::vec3& normal, std::size_t vertex) {
    VertexAttributes attributes;
    attributes.normal = {snorm16(normal.x), snorm16(normal.y), snorm16(normal.z), 0};
    if (!mesh.uvs.empty()) attributes.uv = mesh.uvs[vertex];
    if (!mesh.patch_ids.empty()) attributes.patch = mesh.patch_ids[vertex];
    return attributes;
}

void append_attributes(
    const scene::Mesh& mesh,
    std::span<const glm::vec3> normals,
    std::vector<VertexAttributes>& attributes) {
    for (std::size_t vertex = 0; vertex < normals.size(); ++vertex)
        attributes.push_back(attributes_of(mesh, normals[vertex], vertex));
}

} // namespace

GeometryPool::GeometryPool()
    : positions_(gpu::Buffer::dynamic("geometry/positions")),
      attributes_(gpu::Buffer::dynamic("geometry/attributes")),
      indices_(gpu::Buffer::dynamic("geometry/indices")) {}

void GeometryPool::clear() {
    slots_.clear();
    poses_.clear();
}

void GeometryPool::sync(const scene::World& world) {
    const auto& registry = world.registry;
    bool known = slots_.size() == world.assets.meshes.size()
                 && poses_.size() == registry.count<scene::PosedMesh>();
    registry.each<scene::PosedMesh>([&](ecs::Entity entity, const scene::PosedMesh&) {
        known = known && poses_.contains(entity);
    });
    if (!known) rebuild(world);
    for (auto& [entity, pose] : poses_)
        if (pose.version != registry.version<scene::PosedMesh>(entity))
            upload_pose(world, entity, pose);
}

void GeometryPool::rebuild(const scene::World& world) {
    std::vector<glm::vec3> positions;
    std::vector<VertexAttributes> attributes;
    std::vector<std::uint32_t> indices;
    clear();
    for (const scene::Mesh& mesh : world.assets.meshes) {
        slots_.push_back(
            {static_cast<std::uint32_t>(indices.size()),
             static_cast<std::int32_t>(positions.size())});
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        append_attributes(mesh, mesh.normals, attributes);
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    world.registry.each<scene::PosedMesh>([&](ecs::Entity entity, const scene::PosedMesh& posed) {
        poses_[entity] = {static_cast<std::int32_t>(positions.size()), 0};
        positions.resize(positions.size() + posed.positions.size());
        attributes.resize(positions.size());
    });
    positions_.assign(gpu::bytes_of(positions));
    attributes_.assign(gpu::bytes_of(attributes));
    indices_.assign(gpu::bytes_of(indices));
}

void GeometryPool::upload_pose(const scene::World& world, ecs::Entity entity, Pose& pose) {
    const auto& posed = world.registry.get<scene::PosedMesh>(entity);
    const scene::Mesh& mesh =
        world.assets.meshes[world.registry.get<scene::MeshInstance>(entity).mesh];
    std::vector<VertexAttributes> attributes;
    attributes.reserve(posed.normals.size());
    append_attributes(mesh, posed.normals, attributes);
    const auto first = static_cast<std::size_t>(pose.base_vertex);
    positions_.write(first * sizeof(glm::vec3), gpu::bytes_of(posed.positions));
    attributes_.write(first * sizeof(VertexAttributes), gpu::bytes_of(attributes));
    pose.version = world.registry.version<scene::PosedMesh>(entity);
}

} // namespace render
