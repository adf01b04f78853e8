// Worlds of a few meshes, cameras and lights, in as few words as a test can have.

#pragma once

#include "engine/scene/primitives.hpp"
#include "engine/scene/world.hpp"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace trace {

/// A world with one white, single-sided material, and the ways to fill it.
struct SmallWorld {
    scene::World world;

    SmallWorld() { world.assets.materials.emplace_back(); }

    std::uint32_t add_mesh(scene::Mesh mesh) {
        world.assets.meshes.push_back(std::move(mesh));
        return static_cast<std::uint32_t>(world.assets.meshes.size() - 1);
    }

    /// @param world_from_local affine
    ecs::Entity add(std::uint32_t mesh, const glm::dmat4& world_from_local = glm::dmat4(1.0)) {
        const ecs::Entity entity = world.registry.create();
        world.registry.add<scene::MeshInstance>(entity, {mesh});
        world.registry.add<scene::WorldTransform>(entity, {world_from_local});
        world.registry.add<scene::ShadowRole>(entity);
        return entity;
    }
    ecs::Entity add(scene::Mesh mesh, const glm::dvec3& position = {}) {
        return add(add_mesh(std::move(mesh)), moved(position));
    }

    static glm::dmat4 moved(const glm::dvec3& position) {
        glm::dmat4 matrix(1.0);
        matrix[3] = glm::dvec4(position, 1.0);
        return matrix;
    }
};

inline scene::CameraView
camera_at(const glm::dvec3& eye, const glm::dvec3& target, int width, int height) {
    scene::CameraView camera;
    const glm::dvec3 back = glm::normalize(eye - target);
    const glm::dvec3 up = std::abs(back.y) > 0.99 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    camera.position = eye;
    camera.world_from_view = glm::mat3(right, glm::cross(back, right), back);
    camera.near = 0.01F;
    camera.width = width;
    camera.height = height;
    return camera;
}

inline scene::PlacedLight sun_along(const glm::dvec3& direction, double angular_radius = 0.0) {
    scene::PlacedLight light;
    light.name = "sun";
    light.light.angular_radius = static_cast<float>(angular_radius);
    light.direction = glm::normalize(direction);
    return light;
}

inline scene::PlacedLight lamp_at(const glm::dvec3& position, double radius = 0.0) {
    scene::PlacedLight light;
    light.name = "lamp";
    light.light.kind = scene::LightKind::point;
    light.light.radius = static_cast<float>(radius);
    light.position = position;
    return light;
}

} // namespace trace
