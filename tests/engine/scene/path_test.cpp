// Ways through a level: where something on them is, and which way it looks.

#include "engine/scene/path.hpp"
#include "engine/scene/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scene {

namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

const Path kSquare = {"square", {{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}, true};
const Path kLine = {"line", {{0, 0, 0}, {0, 1, 4}}, false};

TEST(Path, AClosedOneLeadsBackToItsFirstPoint) {
    EXPECT_EQ(period(kSquare), 16.0);
    EXPECT_EQ(place_on(kSquare, 14.0).position, glm::dvec3(2, 0, 0));
    EXPECT_EQ(place_on(kSquare, 18.0).position, glm::dvec3(0, 0, 2));
    EXPECT_EQ(place_on(kSquare, -2.0).position, glm::dvec3(2, 0, 0));
}

TEST(Path, AnOpenOneLeadsToAndFro) {
    const double length = std::sqrt(17.0);

    EXPECT_EQ(period(kLine), 2.0 * length);
    EXPECT_LT(
        glm::length(
            place_on(kLine, 0.75 * length).position - place_on(kLine, 1.25 * length).position),
        1e-12);
    EXPECT_NEAR(place_on(kLine, 0.5 * length).heading, 0.0, 1e-12);
    EXPECT_NEAR(std::abs(place_on(kLine, 1.5 * length).heading), std::numbers::pi, 1e-12);
}

TEST(Path, LooksTheWayItGoesAndTurnsSmoothly) {
    EXPECT_NEAR(place_on(kSquare, 2.0).heading, 0.0, 1e-12);
    EXPECT_NEAR(place_on(kSquare, 6.0).heading, kQuarter, 1e-12);
    EXPECT_NEAR(place_on(kSquare, 4.0).heading, kQuarter / 2.0, 1e-6);

    for (double way = 0.0; way < 32.0; way += 0.01) {
        SCOPED_TRACE(way);
        const double turn = std::remainder(
            place_on(kSquare, way + 0.01).heading - place_on(kSquare, way).heading,
            2.0 * std::numbers::pi);
        ASSERT_LT(std::abs(turn), 0.03);
    }
}

TEST(Path, PointsThatRepeatDoNoHarm) {
    const Path path = {"stutter", {{0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 0, 2}}, true};

    EXPECT_EQ(period(path), 4.0);
    EXPECT_EQ(place_on(path, 3.0).position, glm::dvec3(0, 0, 1));
}

TEST(Path, AFollowerStaysOnItsWayForAnyFrame) {
    World world;
    world.assets.paths.push_back(kSquare);
    const ecs::Entity entity = world.registry.create();
    world.registry.add(entity, Transform{});
    world.registry.add(entity, PathFollower{0, 0.0, -1.5F});

    advance_paths(world, 1.0F);
    EXPECT_EQ(world.registry.get<Transform>(entity).position, glm::dvec3(1.5, 0, 0));
    const glm::vec3 looks = world.registry.get<Transform>(entity).rotation * glm::vec3(0, 0, 1);
    EXPECT_NEAR(looks.x, 1.0F, 1e-5F) << "backwards, it looks the way it goes";

    advance_paths(world, 1000.0F);
    EXPECT_GE(world.registry.get<PathFollower>(entity).travelled, 0.0);
    EXPECT_LT(world.registry.get<PathFollower>(entity).travelled, 16.0);
}

TEST(Path, AFollowerThatStandsStillChangesNothing) {
    World world;
    world.assets.paths.push_back(kSquare);
    const ecs::Entity entity = world.registry.create();
    world.registry.add(entity, Transform{});
    world.registry.add(entity, PathFollower{0, 3.0, 0.0F});
    advance_paths(world, 1.0F);

    const std::uint64_t before = world.registry.version<Transform>(entity);
    advance_paths(world, 1.0F);

    EXPECT_EQ(world.registry.version<Transform>(entity), before);
}

} // namespace

} // namespace scene
