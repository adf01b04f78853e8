#include "engine/scene/primitives.hpp"
#include "systems/shadows/snapshot.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace shadows {
namespace {

/// A world of boxes; returns the entity of each.
class BoxWorld {
public:
    BoxWorld() {
        world.assets.meshes.push_back(scene::make_box({1.0F, 1.0F, 1.0F}));
        world.assets.materials.emplace_back();
    }

    ecs::Entity
    add(const std::string& name,
        const glm::dvec3& position,
        const glm::vec3& scale = glm::vec3(1.0F)) {
        const ecs::Entity entity = world.registry.create();
        world.registry.add(entity, scene::Name{name});
        scene::Transform transform;
        transform.position = position;
        transform.scale = scale;
        world.registry.add(entity, transform);
        world.registry.add(entity, scene::WorldTransform{});
        world.registry.add(entity, scene::MeshInstance{0});
        world.registry.add(entity, scene::ShadowRole{});
        return entity;
    }

    ShadowScene snapshot() {
        scene::update(world, 0.0F);
        const scene::ReceiverTable receivers(world);
        return take_snapshot(world, receivers, camera(), std::vector<scene::PlacedLight>{sun()});
    }

    scene::World world;
};

const ReceiverView& receiver(const ShadowScene& scene, const std::string& name) {
    const auto found =
        std::find_if(scene.receivers.begin(), scene.receivers.end(), [&](const ReceiverView& view) {
            return view.name == name;
        });
    EXPECT_NE(found, scene.receivers.end()) << name;
    return *found;
}

TEST(Snapshot, SidesOfABoxAreFlatReceiversWithTheirPlanes) {
    BoxWorld boxes;
    boxes.add("crate", {2.0, 3.0, 4.0}, {2.0F, 1.0F, 1.0F});

    const ShadowScene scene = boxes.snapshot();

    int flat = 0;
    for (const ReceiverView& view : scene.receivers) {
        if (!view.flat) continue;
        ++flat;
        const glm::dvec3 on_plane = view.bounds.centre();
        EXPECT_NEAR(glm::dot(view.normal, on_plane), view.offset, 1e-6) << view.name;
        EXPECT_GT(glm::dot(view.normal, on_plane - glm::dvec3(2.0, 3.0, 4.0)), 0.0) << view.name;
    }
    EXPECT_EQ(flat, 6);
}

TEST(Snapshot, NamesDecideTheOrderAndNotCreation) {
    BoxWorld one;
    one.add("b", {0, 0, 0});
    one.add("a", {5, 0, 0});
    BoxWorld other;
    other.add("a", {5, 0, 0});
    other.add("b", {0, 0, 0});

    const ShadowScene first = one.snapshot();
    const ShadowScene second = other.snapshot();

    ASSERT_EQ(first.casters.size(), second.casters.size());
    for (std::size_t i = 0; i < first.casters.size(); ++i) {
        EXPECT_EQ(first.casters[i].name, second.casters[i].name);
        EXPECT_EQ(first.casters[i].bounds.min, second.casters[i].bounds.min);
    }
    for (std::size_t i = 0; i < first.receivers.size(); ++i)
        EXPECT_EQ(first.receivers[i].name, second.receivers[i].name);
}

TEST(Snapshot, RolesAreKept) {
    BoxWorld boxes;
    const ecs::Entity ghost = boxes.add("ghost", {0, 0, 0});
    boxes.world.registry.patch<scene::ShadowRole>(ghost, [](scene::ShadowRole& role) {
        role.casts = false;
        role.receives = false;
    });
    const ecs::Entity screen = boxes.add("screen", {6, 0, 0});
    boxes.world.registry.patch<scene::ShadowRole>(
        screen, [](scene::ShadowRole& role) { role.casts = false; });
    boxes.add("solid", {3, 0, 0});

    const ShadowScene scene = boxes.snapshot();

    ASSERT_EQ(scene.casters.size(), 1U);
    EXPECT_EQ(scene.casters[0].name, "solid");
    EXPECT_FALSE(receiver(scene, "screen#1").casts);
    EXPECT_TRUE(receiver(scene, "solid#1").casts);
    EXPECT_FALSE(scene.everything_casts);
    EXPECT_TRUE(scene.casters[0].closed);
    EXPECT_EQ(receiver(scene, "solid#1").entity, scene.casters[0].id);
}

TEST(Snapshot, ABoxIsItsSixSidesAndNothingElse) {
    BoxWorld boxes;
    boxes.add("box", {0, 0, 0});

    const ShadowScene scene = boxes.snapshot();

    ASSERT_EQ(scene.receivers.size(), 6U);
    for (const ReceiverView& side : scene.receivers)
        EXPECT_TRUE(side.flat) << side.name;
}

TEST(ReceiverTable, IdsNameEntityAndPatchBothWays) {
    BoxWorld boxes;
    const ecs::Entity first = boxes.add("first", {0, 0, 0});
    const ecs::Entity second = boxes.add("second", {3, 0, 0});
    const scene::ReceiverTable table(boxes.world);

    EXPECT_EQ(table.end(), 15U); // nothing, and twice a rest and six sides
    EXPECT_EQ(table.part(1).entity, first);
    EXPECT_EQ(table.part(1).patch, 0U);
    EXPECT_EQ(table.part(10).entity, second);
    EXPECT_EQ(table.part(10).patch, 2U);
    EXPECT_EQ(table.find(second)->first, 8U);
    EXPECT_EQ(table.find(ecs::kNoEntity), nullptr);
}

} // namespace
} // namespace shadows
