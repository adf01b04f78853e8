// Small shadow scenes made by hand.

#pragma once

#include "systems/shadows/shadow_scene.hpp"

#include <string>

namespace shadows {

inline engine::WorldAabb box_at(const glm::dvec3& centre, double half) {
    return {centre - half, centre + half};
}

inline CasterView
caster_at(const std::string& name, const glm::dvec3& centre, double half = 0.5, bool hero = false) {
    CasterView caster;
    caster.name = name;
    caster.id = static_cast<std::uint32_t>(std::hash<std::string>()(name));
    caster.bounds = box_at(centre, half);
    caster.hero = hero;
    caster.triangles = 12;
    return caster;
}

inline ReceiverView
receiver_at(const std::string& name, std::uint32_t id, const glm::dvec3& centre, double half) {
    ReceiverView receiver;
    receiver.name = name;
    receiver.id = id;
    receiver.bounds = box_at(centre, half);
    return receiver;
}

inline LightView sun(const glm::vec3& direction = {0.0F, -1.0F, 0.0F}) {
    LightView light;
    light.name = "sun";
    light.id = 1;
    light.direction = glm::normalize(direction);
    return light;
}

inline LightView
lamp(const glm::dvec3& position, float range = std::numeric_limits<float>::infinity()) {
    LightView light;
    light.name = "lamp";
    light.id = 2;
    light.light.kind = scene::LightKind::point;
    light.light.range = range;
    light.position = position;
    return light;
}

/// A camera at (0, 3, 8) that looks at the origin's surroundings, as most scenes here want it.
inline scene::CameraView camera() {
    scene::CameraView view;
    view.position = {0.0, 3.0, 8.0};
    view.width = 512;
    view.height = 512;
    return view;
}

/// A box over a floor, lit from straight above.
inline ShadowScene box_over_floor() {
    ShadowScene scene;
    scene.camera = camera();
    scene.lights = {sun()};
    scene.casters = {caster_at("box", {0.0, 1.0, 0.0})};
    ReceiverView floor = receiver_at("floor", 1, {0.0, -0.5, 0.0}, 0.5);
    floor.bounds = {{-10.0, -0.1, -10.0}, {10.0, 0.0, 10.0}};
    scene.receivers = {floor};
    measure_receivers(scene);
    return scene;
}

} // namespace shadows
