#include "systems/shadows/snapshot.hpp"
#include "systems/shadows/volumes/volume_casters.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

using test_support::at;

/// Two casters over a floor, one of which can bend.
struct VolumeCastersTest : testing::Test {
    test_support::WorldBuilder builder = [] {
        test_support::WorldBuilder made;
        made.add("floor", scene::make_plane(glm::vec2(20.0F)));
        return made;
    }();
    ecs::Entity ball = builder.add("ball", scene::make_sphere(0.5F, 12), at({0.0, 1.0, 0.0}));
    ecs::Entity box = builder.add("box", scene::make_box(glm::vec3(1.0F)), at({2.0, 1.0, 0.0}));
    scene::PlacedLight sun = test_support::sun_light();
    Remedies remedies;
    VolumeCasters casters;

    VolumeCastersTest() {
        scene::Mesh& mesh = builder.world.assets.meshes[1];
        mesh.morph_targets.push_back(
            {std::vector<glm::vec3>(mesh.positions.size(), {0.0F, 0.1F, 0.0F}), {}});
        builder.world.registry.add(ball, scene::MorphWeights{{0.0F}});
        builder.world.registry.add(
            ball, scene::PosedMesh{mesh.positions, mesh.normals, mesh.bounds});
    }

    void update() {
        scene::update(builder.world, 0.0F);
        const ShadowScene snapshot = take_snapshot(
            builder.world,
            scene::ReceiverTable(builder.world),
            test_support::camera_looking({0.0, 3.0, 8.0}, {0.0, 0.0, 0.0}, 256, 256),
            std::vector{sun});
        const std::vector<CasterGroup> groups = group_casters(snapshot, snapshot.lights[0]);
        std::vector<Plan> plans;
        for (const Pair& pair : find_pairs(snapshot, 0, groups)) {
            Plan plan;
            plan.receiver = snapshot.receivers[pair.receiver].id;
            plan.entries.push_back({"volume", pair.groups, {}});
            plans.push_back(plan);
        }
        std::vector<const Plan*> pointers;
        for (const Plan& plan : plans)
            pointers.push_back(&plan);
        const scene::ShadowWish wish;
        const std::function<const trace::TraceScene&()> truth;
        casters.update(
            {builder.world, snapshot, 0, groups, pointers, 100, true, wish, remedies, truth});
    }
};

TEST_F(VolumeCastersTest, BuildOneVolumePerCaster) {
    update();

    EXPECT_EQ(casters.all().size(), 2U);
    EXPECT_EQ(casters.built_count(), 2U);
    EXPECT_TRUE(casters.take_changed());
}

TEST_F(VolumeCastersTest, BuildNothingWhenNothingMoved) {
    update();
    EXPECT_TRUE(casters.take_changed());
    update();

    EXPECT_EQ(casters.all().size(), 2U);
    EXPECT_EQ(casters.built_count(), 0U);
    EXPECT_FALSE(casters.take_changed());
}

TEST_F(VolumeCastersTest, BuildAgainWhatMovedAlone) {
    update();
    builder.world.registry.patch<scene::Transform>(box, [](scene::Transform& transform) {
        transform.rotation = glm::angleAxis(0.1F, glm::vec3(0.0F, 1.0F, 0.0F));
    });
    update();

    EXPECT_EQ(casters.built_count(), 1U);
}

TEST_F(VolumeCastersTest, UnderASunACasterThatGoesStraightKeepsItsVolume) {
    update();
    builder.world.registry.patch<scene::Transform>(
        box, [](scene::Transform& transform) { transform.position.x += 0.25; });
    update();

    EXPECT_EQ(casters.built_count(), 0U);
}

TEST_F(VolumeCastersTest, BuildAgainWhatWasPosed) {
    update();
    builder.world.registry.patch<scene::MorphWeights>(
        ball, [](scene::MorphWeights& weights) { weights.weights[0] = 1.0F; });
    update();

    EXPECT_EQ(casters.built_count(), 1U);
}

TEST_F(VolumeCastersTest, BuildAllAgainWhenTheLightTurns) {
    update();
    sun.direction = glm::normalize(glm::vec3(0.1F, -1.0F, 0.0F));
    update();

    EXPECT_EQ(casters.built_count(), 2U);
}

} // namespace
} // namespace shadows
