#include "engine/script/live_fields.hpp"

#include "engine/scene/framing.hpp"
#include "engine/scene/turns.hpp"

#include <array>

namespace script {

namespace {

using ecs::Entity;
using scene::World;

template <class Component>
const Component& get(const World& world, Entity entity) {
    return world.registry.get<Component>(entity);
}

template <class Component, class Function>
void patch(World& world, Entity entity, Function&& function) {
    world.registry.patch<Component>(entity, std::forward<Function>(function));
}

LiveValue read_position(const World& world, Entity entity) {
    return get<scene::Transform>(world, entity).position;
}

void write_position(World& world, Entity entity, const LiveValue& value) {
    patch<scene::Transform>(world, entity, [&](scene::Transform& transform) {
        transform.position = std::get<glm::dvec3>(value);
    });
}

LiveValue read_rotation(const World& world, Entity entity) {
    return glm::degrees(scene::turns_of(get<scene::Transform>(world, entity).rotation));
}

void write_rotation(World& world, Entity entity, const LiveValue& value) {
    patch<scene::Transform>(world, entity, [&](scene::Transform& transform) {
        transform.rotation = scene::turned_by(glm::radians(std::get<glm::dvec3>(value)));
    });
}

LiveValue read_direction(const World& world, Entity entity) {
    const glm::dquat rotation(get<scene::Transform>(world, entity).rotation);
    return rotation * glm::dvec3(0.0, 0.0, -1.0);
}

/// A direction without length changes nothing.
void write_direction(World& world, Entity entity, const LiveValue& value) {
    const auto& direction = std::get<glm::dvec3>(value);
    if (glm::length(direction) < 1e-9) return;
    patch<scene::Transform>(world, entity, [&](scene::Transform& transform) {
        transform.rotation = scene::rotation_along(direction);
    });
}

LiveValue read_intensity(const World& world, Entity entity) {
    return static_cast<double>(get<scene::Light>(world, entity).intensity);
}

void write_intensity(World& world, Entity entity, const LiveValue& value) {
    patch<scene::Light>(world, entity, [&](scene::Light& light) {
        light.intensity = static_cast<float>(std::get<double>(value));
    });
}

LiveValue read_color(const World& world, Entity entity) {
    return glm::dvec3(get<scene::Light>(world, entity).color);
}

void write_color(World& world, Entity entity, const LiveValue& value) {
    patch<scene::Light>(world, entity, [&](scene::Light& light) {
        light.color = glm::vec3(std::get<glm::dvec3>(value));
    });
}

LiveValue read_on(const World& world, Entity entity) {
    return get<scene::Light>(world, entity).on;
}

void write_on(World& world, Entity entity, const LiveValue& value) {
    patch<scene::Light>(
        world, entity, [&](scene::Light& light) { light.on = std::get<bool>(value); });
}

/// A model without clips has speed 0, and keeps it.
LiveValue read_animation_speed(const World& world, Entity entity) {
    const auto* player = world.registry.try_get<scene::AnimationPlayer>(entity);
    return player == nullptr ? 0.0 : static_cast<double>(player->speed);
}

void write_animation_speed(World& world, Entity entity, const LiveValue& value) {
    if (!world.registry.has<scene::AnimationPlayer>(entity)) return;
    patch<scene::AnimationPlayer>(world, entity, [&](scene::AnimationPlayer& player) {
        player.speed = static_cast<float>(std::get<double>(value));
    });
}

LiveValue read_path_speed(const World& world, Entity entity) {
    const auto* follower = world.registry.try_get<scene::PathFollower>(entity);
    return follower == nullptr ? 0.0 : static_cast<double>(follower->speed);
}

void write_path_speed(World& world, Entity entity, const LiveValue& value) {
    if (!world.registry.has<scene::PathFollower>(entity)) return;
    patch<scene::PathFollower>(world, entity, [&](scene::PathFollower& follower) {
        follower.speed = static_cast<float>(std::get<double>(value));
    });
}

constexpr std::array kFields = {
    LiveField{"sun", "direction", read_direction, write_direction},
    LiveField{"sun", "illuminance", read_intensity, write_intensity},
    LiveField{"sun", "color", read_color, write_color},
    LiveField{"sun", "on", read_on, write_on},
    LiveField{"spot", "position", read_position, write_position},
    LiveField{"spot", "direction", read_direction, write_direction},
    LiveField{"spot", "intensity", read_intensity, write_intensity},
    LiveField{"spot", "color", read_color, write_color},
    LiveField{"spot", "on", read_on, write_on},
    LiveField{"lamp", "position", read_position, write_position},
    LiveField{"lamp", "intensity", read_intensity, write_intensity},
    LiveField{"lamp", "color", read_color, write_color},
    LiveField{"lamp", "on", read_on, write_on},
    LiveField{"camera", "position", read_position, write_position},
    LiveField{"camera", "rotation", read_rotation, write_rotation},
    LiveField{"model", "position", read_position, write_position},
    LiveField{"model", "rotation", read_rotation, write_rotation},
    LiveField{"model", "animation_speed", read_animation_speed, write_animation_speed},
    LiveField{"model", "path_speed", read_path_speed, write_path_speed},
};

} // namespace

std::span<const LiveField> live_fields() {
    return kFields;
}

std::string_view live_kind(const World& world, Entity entity) {
    if (world.registry.has<scene::Camera>(entity)) return "camera";
    const auto* light = world.registry.try_get<scene::Light>(entity);
    if (light == nullptr) return "model";
    switch (light->kind) {
    case scene::LightKind::directional:
        return "sun";
    case scene::LightKind::spot:
        return "spot";
    case scene::LightKind::point:
        return "lamp";
    }
    return "model";
}

} // namespace script
