#include "engine/scene/views.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tools/gnomon/scene_motion.hpp"

namespace gnomon {
namespace {

using test_support::at;

/// A floor with a small and a large box, a sun and a lamp.
test_support::WorldBuilder yard() {
    test_support::WorldBuilder builder = test_support::floor_of(20.0F);
    builder.add("small", scene::make_box(glm::vec3(1.0F)), at({-2.0, 0.5, 0.0}));
    builder.add("large", scene::make_box(glm::vec3(2.0F)), at({2.0, 1.0, 0.0}));
    builder.add_light(test_support::sun_light());
    builder.add_light(test_support::lamp_light("lamp", {0.0, 3.0, 0.0}, 10.0F, 8.0F));
    scene::update(builder.world, 0.0F);
    return builder;
}

/// Looks along -X, so that its right is -Z.
scene::CameraView camera() {
    return test_support::camera_looking({8.0, 2.0, 0.0}, {0.0, 2.0, 0.0}, 64, 64);
}

scene::PlacedLight light(const scene::World& world, const std::string& name) {
    for (const scene::PlacedLight& placed : scene::placed_lights(world))
        if (placed.name == name) return placed;
    ADD_FAILURE() << "no light " << name;
    return {};
}

glm::dvec3 place(const scene::World& world, const std::string& name) {
    glm::dvec3 found(0.0);
    world.registry.each<scene::Name, scene::WorldTransform>(
        [&](ecs::Entity, const scene::Name& text, const scene::WorldTransform& transform) {
            if (text.text == name) found = glm::dvec3(transform.world_from_local[3]);
        });
    return found;
}

TEST(SceneMotion, TheSunTurnsByAFiftiethOfADegreeAFrame) {
    auto builder = yard();
    const glm::dvec3 before(light(builder.world, "sun").direction);
    SceneMotion motion(builder.world, "sun", camera());

    for (const int frame : {1, 50, 500}) {
        SCOPED_TRACE(frame);
        motion.pose(frame);
        const glm::dvec3 now(light(builder.world, "sun").direction);

        const double angle =
            std::atan2(glm::length(glm::cross(before, now)), glm::dot(before, now));
        EXPECT_NEAR(angle * 180.0 / std::numbers::pi, 0.02 * frame, 2e-4);
        EXPECT_NEAR(std::atan2(now.x, now.z), std::atan2(before.x, before.z), 1e-5)
            << "only its height changes";
    }
    EXPECT_EQ(light(builder.world, "lamp").position, glm::dvec3(0.0, 3.0, 0.0));
}

TEST(SceneMotion, ALampGoesToTheCamerasRight) {
    auto builder = yard();
    const scene::PlacedLight sun = light(builder.world, "sun");
    SceneMotion motion(builder.world, "light", camera());

    motion.pose(30);

    const glm::dvec3 now = light(builder.world, "lamp").position;
    EXPECT_NEAR(glm::length(now - glm::dvec3(0.0, 3.0, -0.7)), 0.0, 1e-6);
    EXPECT_EQ(light(builder.world, "sun").direction, sun.direction);
}

TEST(SceneMotion, TheLargestCasterThatIsNoFloorRunsToAndFro) {
    auto builder = yard();
    SceneMotion motion(builder.world, "casters", camera());
    const auto way = [&](int frame) {
        motion.pose(frame);
        return -place(builder.world, "large").z;
    };

    EXPECT_NEAR(way(16), 16.0 / 30.0, 1e-9) << "2 m/s at 60 frames a second";
    EXPECT_NEAR(way(32), 32.0 / 30.0, 1e-9);
    EXPECT_NEAR(way(48), 16.0 / 30.0, 1e-9);
    EXPECT_NEAR(way(64), 0.0, 1e-9);
    EXPECT_NEAR(way(70), 6.0 / 30.0, 1e-9);
    EXPECT_EQ(place(builder.world, "small"), glm::dvec3(-2.0, 0.5, 0.0));
    EXPECT_EQ(place(builder.world, "floor"), glm::dvec3(0.0));
}

TEST(SceneMotion, WhatGoesAlongAPathRunsInsteadOfTheLargest) {
    auto builder = yard();
    builder.world.assets.paths.emplace_back();
    builder.world.registry.each<scene::Name>([&](ecs::Entity entity, const scene::Name& name) {
        if (name.text == "small") builder.world.registry.add(entity, scene::PathFollower{});
    });
    SceneMotion motion(builder.world, "casters", camera());

    motion.pose(16);

    EXPECT_NEAR(place(builder.world, "small").z, -16.0 / 30.0, 1e-9);
    EXPECT_EQ(place(builder.world, "large"), glm::dvec3(2.0, 1.0, 0.0));
}

TEST(SceneMotion, WhatHangsOnAnotherMovesInTheWorldsWay) {
    auto builder = yard();
    ecs::Registry& registry = builder.world.registry;
    const ecs::Entity turned = registry.create();
    scene::Transform turn;
    turn.rotation = glm::angleAxis(1.0F, glm::vec3(0.0F, 1.0F, 0.0F));
    turn.scale = glm::vec3(2.0F);
    registry.add(turned, turn);
    registry.each<scene::Name>([&](ecs::Entity entity, const scene::Name& name) {
        if (name.text == "large") registry.add(entity, scene::Parent{turned});
    });
    scene::update(builder.world, 0.0F);
    const glm::dvec3 before = place(builder.world, "large");
    SceneMotion motion(builder.world, "casters", camera());

    motion.pose(15);

    const glm::dvec3 way = place(builder.world, "large") - before;
    EXPECT_NEAR(glm::length(way - glm::dvec3(0.0, 0.0, -0.5)), 0.0, 1e-6);
}

TEST(SceneMotion, LeavesTheWorldAsItWas) {
    auto builder = yard();
    const scene::PlacedLight sun = light(builder.world, "sun");
    const glm::dvec3 lamp = light(builder.world, "lamp").position;
    const glm::dvec3 large = place(builder.world, "large");
    for (const char* protocol : {"sun", "light", "casters", "play"}) {
        SceneMotion motion(builder.world, protocol, camera());
        motion.pose(17);
    }

    EXPECT_EQ(light(builder.world, "sun").direction, sun.direction);
    EXPECT_EQ(light(builder.world, "lamp").position, lamp);
    EXPECT_EQ(place(builder.world, "large"), large);
}

TEST(SceneMotion, MovesNothingByTheCamerasProtocols) {
    auto builder = yard();

    EXPECT_FALSE(SceneMotion(builder.world, "walk", camera()).moves_anything());
    EXPECT_TRUE(SceneMotion(builder.world, "sun", camera()).moves_anything());
}

} // namespace
} // namespace gnomon
