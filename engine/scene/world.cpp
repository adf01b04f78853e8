// Placing entities in the world, parents first, and the bounds of what is placed.

#include "engine/scene/world.hpp"

#include "engine/core/check.hpp"

#include <atomic>
#include <unordered_map>

namespace scene {

namespace {

std::uint64_t next_world() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

void give_world_transforms(ecs::Registry& registry) {
    std::vector<ecs::Entity> without;
    registry.each<Transform>([&](ecs::Entity entity, const Transform& /*transform*/) {
        if (!registry.has<WorldTransform>(entity)) without.push_back(entity);
    });
    for (const ecs::Entity entity : without)
        registry.add<WorldTransform>(entity);
}

/// The parent that takes part in placing, or kNoEntity.
ecs::Entity placed_parent(const ecs::Registry& registry, ecs::Entity entity) {
    const Parent* parent = registry.try_get<Parent>(entity);
    return parent && registry.has<Transform>(parent->entity) ? parent->entity : ecs::kNoEntity;
}

std::vector<PlacementOrder::Entry> parents_first(const ecs::Registry& registry) {
    std::vector<PlacementOrder::Entry> entries;
    std::unordered_map<ecs::Entity, std::uint32_t> placed;
    const std::size_t count = registry.count<Transform>();
    entries.reserve(count);
    placed.reserve(count);
    std::vector<ecs::Entity> line;
    for (const ecs::Entity entity : registry.view<Transform>()) {
        line.clear();
        ecs::Entity next = entity;
        for (; next != ecs::kNoEntity && !placed.contains(next);
             next = placed_parent(registry, next)) {
            CHECK_LT(line.size(), count); // an entity is its own ancestor
            line.push_back(next);
        }
        std::uint32_t parent = next == ecs::kNoEntity ? PlacementOrder::kNoParent : placed.at(next);
        for (auto it = line.rbegin(); it != line.rend(); ++it) {
            const auto index = static_cast<std::uint32_t>(entries.size());
            entries.push_back({*it, parent, 0});
            placed.emplace(*it, index);
            parent = index;
        }
    }
    return entries;
}

} // namespace

WorldIdentity::WorldIdentity() : number_(next_world()) {}

void update_world_transforms(World& world) {
    ecs::Registry& registry = world.registry;
    PlacementOrder& order = world.placement;
    const bool transforms_changed = order.transforms_version != registry.version<Transform>();
    if (transforms_changed) give_world_transforms(registry);
    const bool order_changed =
        order.parents_version != registry.version<Parent>()
        || order.world_transforms_version != registry.version<WorldTransform>()
        || order.entries.size() != registry.count<Transform>();
    if (!transforms_changed && !order_changed) return;
    if (order_changed) order.entries = parents_first(registry);

    std::vector<char> changed(order.entries.size());
    for (std::size_t i = 0; i < order.entries.size(); ++i) {
        PlacementOrder::Entry& entry = order.entries[i];
        const bool has_parent = entry.parent != PlacementOrder::kNoParent;
        const std::uint64_t version = registry.version<Transform>(entry.entity);
        if (version == entry.transform_version && !(has_parent && changed[entry.parent] != 0))
            continue;
        entry.transform_version = version;

        glm::dmat4 world_from_local = registry.get<Transform>(entry.entity).matrix();
        if (has_parent)
            world_from_local =
                registry.get<WorldTransform>(order.entries[entry.parent].entity).world_from_local
                * world_from_local;
        if (registry.get<WorldTransform>(entry.entity).world_from_local == world_from_local)
            continue;
        registry.patch<WorldTransform>(entry.entity, [&](WorldTransform& placed) {
            placed.world_from_local = world_from_local;
        });
        changed[i] = 1;
    }
    order.transforms_version = registry.version<Transform>();
    order.parents_version = registry.version<Parent>();
    order.world_transforms_version = registry.version<WorldTransform>();
}

void update(World& world, float dt) {
    advance_paths(world, dt);
    advance_animations(world, dt);
    update_world_transforms(world);
    pose_meshes(world);
}

engine::WorldAabb world_bounds(const World& world, ecs::Entity entity) {
    const auto* instance = world.registry.try_get<MeshInstance>(entity);
    const auto* placed = world.registry.try_get<WorldTransform>(entity);
    if (!instance || !placed) return {};
    const auto* posed = world.registry.try_get<PosedMesh>(entity);
    return engine::transformed(
        placed->world_from_local,
        posed ? posed->bounds : world.assets.meshes[instance->mesh].bounds);
}

engine::WorldAabb world_bounds(const World& world) {
    engine::WorldAabb bounds;
    for (const ecs::Entity entity : world.registry.view<MeshInstance>())
        bounds.grow(world_bounds(world, entity));
    return bounds;
}

} // namespace scene
