// Worlds made by hand for tests that draw or trace.

#pragma once

#include "engine/scene/camera.hpp"
#include "engine/scene/framing.hpp"
#include "engine/scene/primitives.hpp"
#include "engine/scene/receivers.hpp"
#include "engine/scene/world.hpp"

#include <cmath>
#include <string>

namespace test_support {

/// A world to which meshes are added one by one, moved as a whole by `origin`.
class WorldBuilder {
public:
    explicit WorldBuilder(const glm::dvec3& origin = {}) : origin_(origin) {
        world.assets.materials.emplace_back();
    }

    /// A new mesh, and one entity that shows it.
    ecs::Entity add(const std::string& name, scene::Mesh mesh, const scene::Transform& at = {}) {
        world.assets.meshes.push_back(std::move(mesh));
        return add_instance(name, static_cast<std::uint32_t>(world.assets.meshes.size() - 1), at);
    }

    ecs::Entity add_instance(const std::string& name, std::uint32_t mesh, scene::Transform at) {
        const ecs::Entity entity = world.registry.create();
        at.position += origin_;
        world.registry.add(entity, scene::Name{name});
        world.registry.add(entity, at);
        world.registry.add(entity, scene::WorldTransform{});
        world.registry.add(entity, scene::MeshInstance{mesh});
        world.registry.add(entity, scene::ShadowRole{});
        return entity;
    }

    /// A light as an entity, so that scene::placed_lights finds it.
    ecs::Entity add_light(const scene::PlacedLight& light) {
        const ecs::Entity entity = world.registry.create();
        scene::Transform transform;
        transform.position = light.position + origin_;
        transform.rotation = scene::rotation_along(light.direction);
        world.registry.add(entity, scene::Name{light.name});
        world.registry.add(entity, transform);
        world.registry.add(entity, scene::WorldTransform{});
        world.registry.add(entity, light.light);
        return entity;
    }

    scene::World world;

private:
    glm::dvec3 origin_;
};

/// A world with a square floor at height 0, called "floor".
inline WorldBuilder floor_of(float side) {
    WorldBuilder builder;
    builder.add("floor", scene::make_plane(glm::vec2(side)));
    return builder;
}

/// Adds `part`, moved by `offset`, to a mesh that is not finished yet.
inline void add_part(scene::Mesh& mesh, const scene::Mesh& part, const glm::vec3& offset) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& position : part.positions)
        mesh.positions.push_back(position + offset);
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
    for (const std::uint32_t index : part.indices)
        mesh.indices.push_back(first + index);
    mesh.submeshes.clear();
    mesh.patches.clear();
    mesh.patch_ids.clear();
}

/// Adds `part`, moved by `offset`, to a mesh: one entity, several solids.
inline void append(scene::Mesh& mesh, const scene::Mesh& part, const glm::vec3& offset) {
    add_part(mesh, part, offset);
    scene::finish_mesh(mesh);
}

inline scene::Transform at(const glm::dvec3& position, const glm::vec3& scale = glm::vec3(1.0F)) {
    scene::Transform transform;
    transform.position = position;
    transform.scale = scale;
    return transform;
}

/// A sun that shines down and to the right and back.
inline scene::PlacedLight sun_light(float illuminance = 3.0F) {
    scene::PlacedLight light;
    light.name = "sun";
    light.light.intensity = illuminance;
    light.direction = glm::normalize(glm::vec3(0.4F, -1.0F, -0.3F));
    return light;
}

inline scene::PlacedLight sun_along(const glm::dvec3& direction) {
    scene::PlacedLight sun = sun_light();
    sun.direction = glm::vec3(glm::normalize(direction));
    return sun;
}

/// A sun above the horizon whose light goes to the right, or with an azimuth more and more toward
/// the camera.
/// @param elevation degrees, as is azimuth
inline scene::PlacedLight sun_at(double elevation, double azimuth = 0.0) {
    const double up = glm::radians(elevation);
    const double around = glm::radians(azimuth);
    return sun_along(
        {std::cos(up) * std::cos(around), -std::sin(up), std::cos(up) * std::sin(around)});
}

inline scene::PlacedLight
lamp_light(const std::string& name, const glm::dvec3& position, float intensity, float range) {
    scene::PlacedLight light;
    light.name = name;
    light.light.kind = scene::LightKind::point;
    light.light.intensity = intensity;
    light.light.range = range;
    light.position = position;
    return light;
}

/// A camera at `eye` that looks at `target`, 60 degrees high.
inline scene::CameraView
camera_looking(const glm::dvec3& eye, const glm::dvec3& target, int width, int height) {
    scene::CameraView camera;
    camera.position = eye;
    camera.world_from_view = glm::mat3_cast(scene::rotation_along(target - eye));
    camera.width = width;
    camera.height = height;
    return camera;
}

/// Sees the surroundings of the origin from 8 m away and a little above.
inline scene::CameraView usual_camera(int size_px) {
    return camera_looking({0.0, 3.0, 8.0}, {0.0, 0.5, 0.0}, size_px, size_px);
}

} // namespace test_support
