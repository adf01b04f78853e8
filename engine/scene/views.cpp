#include "engine/scene/views.hpp"

#include <algorithm>
#include <tuple>

namespace scene {

namespace {

std::string name_of(const World& world, ecs::Entity entity) {
    const Name* name = world.registry.try_get<Name>(entity);
    return name != nullptr ? name->text : std::string();
}

/// Rotation without scale or mirroring; -Z is the way that the entity looks.
glm::mat3 rotation_of(const WorldTransform& transform) {
    return glm::mat3_cast(decompose(transform.world_from_local).transform.rotation);
}

/// All cameras, the oldest entity first.
std::vector<ecs::Entity> cameras(const World& world) {
    std::vector<ecs::Entity> entities;
    world.registry.each<Camera, WorldTransform>(
        [&](ecs::Entity entity, const Camera& /*camera*/, const WorldTransform& /*transform*/) {
            entities.push_back(entity);
        });
    std::sort(entities.begin(), entities.end());
    return entities;
}

} // namespace

std::vector<PlacedLight> placed_lights(const World& world) {
    std::vector<PlacedLight> lights;
    world.registry.each<Light, WorldTransform>(
        [&](ecs::Entity entity, const Light& light, const WorldTransform& transform) {
            if (!light.on) return;
            PlacedLight placed;
            placed.name = name_of(world, entity);
            placed.id = entity.value;
            placed.light = light;
            placed.position = glm::dvec3(transform.world_from_local[3]);
            placed.direction = glm::normalize(-rotation_of(transform)[2]);
            lights.push_back(std::move(placed));
        });
    std::sort(lights.begin(), lights.end(), [](const PlacedLight& left, const PlacedLight& right) {
        return std::tie(left.name, left.id) < std::tie(right.name, right.id);
    });
    return lights;
}

std::vector<std::string> camera_names(const World& world) {
    std::vector<std::string> names;
    for (const ecs::Entity entity : cameras(world))
        names.push_back(name_of(world, entity));
    return names;
}

std::optional<CameraView>
find_camera(const World& world, std::string_view name, int width, int height) {
    for (const ecs::Entity entity : cameras(world)) {
        if (!name.empty() && name_of(world, entity) != name) continue;
        const auto& camera = world.registry.get<Camera>(entity);
        const auto& transform = world.registry.get<WorldTransform>(entity);
        CameraView view;
        view.name = name_of(world, entity);
        view.position = glm::dvec3(transform.world_from_local[3]);
        view.world_from_view = rotation_of(transform);
        view.fov_y = camera.fov_y;
        view.near = camera.near;
        view.width = width;
        view.height = height;
        return view;
    }
    return std::nullopt;
}

} // namespace scene
