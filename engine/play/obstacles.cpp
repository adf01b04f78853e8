#include "engine/play/obstacles.hpp"

#include <algorithm>

namespace play {

namespace {

/// Whether the entity, or one above it, goes along a path.
bool travels(const ecs::Registry& registry, ecs::Entity entity) {
    for (;;) {
        if (registry.has<scene::PathFollower>(entity)) return true;
        const auto* parent = registry.try_get<scene::Parent>(entity);
        if (parent == nullptr) return false;
        entity = parent->entity;
    }
}

void append(
    const scene::Mesh& mesh, const glm::dmat4& world_from_local, std::vector<Triangle>& triangles) {
    const auto corner = [&](std::uint32_t index) {
        return glm::dvec3(world_from_local * glm::dvec4(mesh.positions[mesh.indices[index]], 1.0));
    };
    for (const scene::Submesh& submesh : mesh.submeshes) {
        if (submesh.topology != scene::Topology::triangles) continue;
        const std::uint32_t end = submesh.first_index + submesh.index_count;
        for (std::uint32_t i = submesh.first_index; i < end; i += 3)
            triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
    }
}

} // namespace

std::vector<Triangle> standing_triangles(const scene::World& world) {
    std::vector<Triangle> triangles;
    world.registry.each<scene::MeshInstance, scene::WorldTransform>(
        [&](ecs::Entity entity, const scene::MeshInstance& instance, const auto& placed) {
            const scene::Mesh& mesh = world.assets.meshes[instance.mesh];
            if (!mesh.deforms() && !travels(world.registry, entity))
                append(mesh, placed.world_from_local, triangles);
        });
    return triangles;
}

Obstacles::Obstacles(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

engine::WorldAabb Obstacles::bounds_of(const Triangle& triangle) {
    engine::WorldAabb bounds;
    for (const glm::dvec3& corner : triangle)
        bounds.grow(corner);
    return bounds;
}

/// Halves the triangles along the longest side of their box. @return the node's number
std::uint32_t Obstacles::build(std::uint32_t first, std::uint32_t count) {
    constexpr std::uint32_t kLeafSize = 4;
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    engine::WorldAabb bounds;
    for (std::uint32_t i = first; i < first + count; ++i)
        bounds.grow(bounds_of(triangles_[i]));
    nodes_[number].bounds = bounds;
    nodes_[number].first = first;
    if (count <= kLeafSize) {
        nodes_[number].count = count;
        return number;
    }
    const glm::dvec3 extent = bounds.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const auto middle_of = [axis](const Triangle& triangle) {
        return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
    };
    const auto begin = triangles_.begin() + first;
    std::stable_sort(begin, begin + count, [&](const Triangle& left, const Triangle& right) {
        return middle_of(left) < middle_of(right);
    });
    const std::uint32_t half = count / 2;
    const std::uint32_t first_child = build(first, half);
    const std::uint32_t second_child = build(first + half, count - half);
    nodes_[number].first = first_child;
    nodes_[number].second_child = second_child;
    return number;
}

} // namespace play
