// Playing clips: each player's clock moves on, and the channels of its clip are written to the
// entities of its nodes. A value that is there already is not written again, so that a still scene
// keeps its versions.

#include "engine/core/check.hpp"
#include "engine/scene/world.hpp"

#include <algorithm>
#include <cmath>

namespace scene {

namespace {

float wrapped(float time, float duration, bool loops) {
    if (!(duration > 0.0F)) return 0.0F;
    if (!loops) return std::clamp(time, 0.0F, duration);
    const float rest = std::fmod(time, duration);
    return rest < 0.0F ? rest + duration : rest;
}

template <class Component, class T>
void write(ecs::Registry& registry, ecs::Entity entity, T Component::*member, const T& value) {
    const Component* component = registry.try_get<Component>(entity);
    if (!component || component->*member == value) return;
    registry.patch<Component>(entity, [&](Component& changed) { changed.*member = value; });
}

void apply(
    ecs::Registry& registry,
    const AnimationChannel& channel,
    ecs::Entity entity,
    std::vector<float>& value) {
    switch (channel.property) {
    case AnimatedProperty::translation:
        write(registry, entity, &Transform::position, glm::dvec3(value[0], value[1], value[2]));
        break;
    case AnimatedProperty::rotation:
        write(
            registry,
            entity,
            &Transform::rotation,
            glm::quat(value[3], value[0], value[1], value[2]));
        break;
    case AnimatedProperty::scale:
        write(registry, entity, &Transform::scale, glm::vec3(value[0], value[1], value[2]));
        break;
    case AnimatedProperty::morph_weights:
        write(registry, entity, &MorphWeights::weights, value);
        break;
    }
}

} // namespace

void advance_animations(World& world, float dt) {
    ecs::Registry& registry = world.registry;
    std::vector<float> value;
    for (const ecs::Entity entity : registry.view<AnimationPlayer>()) {
        const auto& player = registry.get<AnimationPlayer>(entity);
        CHECK_LT(player.clip, player.clip_count);
        const AnimationClip& clip = world.assets.clips[player.first_clip + player.clip];
        const float time = wrapped(player.time + dt * player.speed, clip.duration, player.loops);
        write(registry, entity, &AnimationPlayer::time, time);
        for (const AnimationChannel& channel : clip.channels) {
            value.resize(channel.width);
            sample(channel, time, value.data());
            apply(registry, channel, player.nodes[channel.node], value);
        }
    }
}

} // namespace scene
