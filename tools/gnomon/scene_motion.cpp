#include "tools/gnomon/scene_motion.hpp"

#include "engine/scene/light.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tools/gnomon/motion_protocols.hpp"

namespace gnomon {

namespace {

constexpr double kSunTurn = 0.02 * std::numbers::pi / 180.0; // per frame
constexpr double kLightSpeed = 1.4;                          // m/s
constexpr double kCasterSpeed = 2.0;                         // m/s
constexpr int kFramesOneWay = 32;
constexpr glm::dvec3 kUp = {0.0, 1.0, 0.0};

/// A direction made level and unit; `other` when it has no level part.
glm::dvec3 level(glm::dvec3 direction, const glm::dvec3& other) {
    direction.y = 0.0;
    return glm::length(direction) < 1e-6 ? other : glm::normalize(direction);
}

bool casts(const ecs::Registry& registry, ecs::Entity entity) {
    const auto* role = registry.try_get<scene::ShadowRole>(entity);
    return role == nullptr || role->casts;
}

/// The topmost of those that move an entity by being above it, itself included.
ecs::Entity
topmost(const ecs::Registry& registry, const std::set<ecs::Entity>& movers, ecs::Entity entity) {
    ecs::Entity found = ecs::kNoEntity;
    for (ecs::Entity at = entity;;) {
        if (movers.contains(at)) found = at;
        const auto* parent = registry.try_get<scene::Parent>(at);
        if (parent == nullptr || !registry.alive(parent->entity)) return found;
        at = parent->entity;
    }
}

/// Entities whose Transforms paths and animations write.
std::set<ecs::Entity> movers_of(const scene::World& world) {
    std::set<ecs::Entity> movers;
    world.registry.each<scene::PathFollower>(
        [&](ecs::Entity entity, const scene::PathFollower&) { movers.insert(entity); });
    world.registry.each<scene::AnimationPlayer>(
        [&](ecs::Entity, const scene::AnimationPlayer& player) {
            for (std::uint32_t clip = 0; clip < player.clip_count; ++clip)
                for (const auto& channel : world.assets.clips[player.first_clip + clip].channels)
                    movers.insert(player.nodes[channel.node]);
        });
    return movers;
}

/// The largest caster whose footprint covers less than half of the world's; none when there is no
/// such caster.
ecs::Entity largest_caster(const scene::World& world) {
    const auto footprint = [](const engine::WorldAabb& box) {
        return box.empty() ? 0.0 : box.extent().x * box.extent().z;
    };
    const double whole = footprint(scene::world_bounds(world));
    ecs::Entity found = ecs::kNoEntity;
    double largest = 0.0;
    world.registry.each<scene::MeshInstance>([&](ecs::Entity entity, const scene::MeshInstance&) {
        const engine::WorldAabb bounds = scene::world_bounds(world, entity);
        if (!casts(world.registry, entity) || bounds.empty()) return;
        const double size = glm::length(bounds.extent());
        if (size <= largest || footprint(bounds) > 0.5 * whole) return;
        largest = size;
        found = entity;
    });
    return found;
}

} // namespace

SceneMotion::SceneMotion(
    scene::World& world, std::string_view protocol, const scene::CameraView& camera)
    : world_(world),
      sideways_(level(glm::dvec3(camera.world_from_view[0]), {1.0, 0.0, 0.0})) {
    if (protocol == "sun") add_lights(true);
    if (protocol == "light") {
        speed_ = kLightSpeed;
        add_lights(false);
    }
    if (protocol == "casters") {
        speed_ = kCasterSpeed;
        to_and_fro_ = true;
        add_casters();
    }
}

SceneMotion::~SceneMotion() {
    for (const Moved& moved : moved_)
        world_.registry.patch<scene::Transform>(
            moved.entity, [&](scene::Transform& transform) { transform = moved.found; });
    settle();
}

void SceneMotion::add(ecs::Entity entity, const glm::dvec3& axis) {
    const ecs::Registry& registry = world_.registry;
    const auto* transform = registry.try_get<scene::Transform>(entity);
    const auto* placed = registry.try_get<scene::WorldTransform>(entity);
    if (transform == nullptr || placed == nullptr) return;
    moved_.push_back({entity, *transform, placed->world_from_local, axis});
}

void SceneMotion::add_lights(bool directional) {
    world_.registry.each<scene::Light, scene::WorldTransform>(
        [&](ecs::Entity entity, const scene::Light& light, const scene::WorldTransform& placed) {
            if ((light.kind == scene::LightKind::directional) != directional) return;
            const glm::dvec3 across = glm::cross(kUp, -glm::dvec3(placed.world_from_local[2]));
            add(entity, directional ? level(across, {1.0, 0.0, 0.0}) : glm::dvec3(0.0));
        });
}

void SceneMotion::add_casters() {
    const ecs::Registry& registry = world_.registry;
    const std::set<ecs::Entity> movers = movers_of(world_);
    std::set<ecs::Entity> chosen;
    registry.each<scene::MeshInstance>([&](ecs::Entity entity, const scene::MeshInstance&) {
        if (!casts(registry, entity)) return;
        // A skinned mesh goes where its joints go, wherever its own node is.
        const auto* skin = registry.try_get<scene::Skinned>(entity);
        const bool by_joints = skin != nullptr && !skin->joints.empty();
        chosen.insert(topmost(registry, movers, by_joints ? skin->joints.front() : entity));
    });
    chosen.erase(ecs::kNoEntity);
    if (chosen.empty()) chosen.insert(largest_caster(world_));
    chosen.erase(ecs::kNoEntity);
    for (const ecs::Entity entity : chosen)
        if (topmost(registry, chosen, entity) == entity) add(entity);
}

void SceneMotion::pose(int frame) {
    const int way = frame % (2 * kFramesOneWay);
    const int steps = to_and_fro_ && way > kFramesOneWay ? 2 * kFramesOneWay - way
                      : to_and_fro_                      ? way
                                                         : frame;
    const glm::dmat4 shift =
        glm::translate(glm::dmat4(1.0), sideways_ * (speed_ * kFrameSeconds * steps));
    for (const Moved& moved : moved_) {
        glm::dmat4 wanted = shift * moved.world_from_local;
        if (moved.axis != glm::dvec3(0.0))
            wanted = glm::rotate(glm::dmat4(1.0), kSunTurn * frame, moved.axis) * wanted;
        const auto* parent = world_.registry.try_get<scene::Parent>(moved.entity);
        const auto* above = parent == nullptr || !world_.registry.alive(parent->entity)
                                ? nullptr
                                : world_.registry.try_get<scene::WorldTransform>(parent->entity);
        const glm::dmat4 local =
            above == nullptr ? wanted : glm::inverse(above->world_from_local) * wanted;
        const scene::Transform transform =
            frame == 0 ? moved.found : scene::decompose(local).transform;
        world_.registry.patch<scene::Transform>(
            moved.entity, [&](scene::Transform& now) { now = transform; });
    }
    settle();
}

/// What follows from Transforms, without letting time pass.
void SceneMotion::settle() {
    scene::update_world_transforms(world_);
    scene::pose_meshes(world_);
}

} // namespace gnomon
