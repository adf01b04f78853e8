#include "engine/core/random.hpp"
#include "systems/shadows/pairs.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace shadows {
namespace {

TEST(CanShadow, ABoxShadowsWhatLiesBehindItAlongTheSun) {
    EXPECT_TRUE(can_shadow(sun(), box_at({0, 5, 0}, 1), box_at({0, 0, 0}, 1)));
}

TEST(CanShadow, ABoxShadowsNothingThatIsNearerToTheSun) {
    EXPECT_FALSE(can_shadow(sun(), box_at({0, 0, 0}, 1), box_at({0, 5, 0}, 1)));
}

TEST(CanShadow, ABoxShadowsNothingBesideItsSweep) {
    EXPECT_FALSE(can_shadow(sun(), box_at({0, 5, 0}, 1), box_at({2.1, 0, 0}, 1)));
}

TEST(CanShadow, ALowSunThrowsFar) {
    const LightView low = sun({1.0F, -0.1F, 0.0F});

    EXPECT_TRUE(can_shadow(low, box_at({0, 5, 0}, 1), box_at({50, 0, 0}, 1)));
    EXPECT_FALSE(can_shadow(low, box_at({0, 5, 0}, 1), box_at({20, 0, 0}, 1)));
}

TEST(CanShadow, AHalfSunkBoxShadowsItself) {
    EXPECT_TRUE(can_shadow(sun(), box_at({0, 0, 0}, 1), box_at({0, 0, 0}, 1)));
}

TEST(CanShadow, ALampShadowsOnlyItsOtherSide) {
    const LightView light = lamp({0, 5, 0});

    EXPECT_TRUE(can_shadow(light, box_at({0, 3, 0}, 0.5), box_at({0, 0, 0}, 1)));
    EXPECT_FALSE(can_shadow(light, box_at({0, 3, 0}, 0.5), box_at({0, 9, 0}, 1)));
}

/// Whether some ray from a point of the light hits both boxes in order, by trying many.
bool sampled_shadow(
    const LightView& light,
    const engine::WorldAabb& caster,
    const engine::WorldAabb& receiver,
    engine::Random& random) {
    const auto inside = [&](const engine::WorldAabb& box) {
        return glm::dvec3(
            random.uniform(box.min.x, box.max.x),
            random.uniform(box.min.y, box.max.y),
            random.uniform(box.min.z, box.max.z));
    };
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 blocker = inside(caster);
        const glm::dvec3 along = light.light.kind == scene::LightKind::directional
                                     ? glm::dvec3(light.direction)
                                     : blocker - light.position;
        for (int k = 0; k < 60; ++k)
            if (receiver.contains(blocker + along * (k * 0.1))) return true;
    }
    return false;
}

TEST(CanShadow, IsNeverFalseForAShadowThatExists) {
    engine::Random random(7);
    for (int trial = 0; trial < 400; ++trial) {
        SCOPED_TRACE(trial);
        const auto place = [&] {
            return glm::dvec3(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
        };
        const auto caster = box_at(place(), random.uniform(0.1, 1.0));
        const auto receiver = box_at(place(), random.uniform(0.1, 1.0));
        const LightView light = trial % 2 == 0 ? sun(glm::vec3(place())) : lamp(place());
        EXPECT_TRUE(
            can_shadow(light, caster, receiver)
            || !sampled_shadow(light, caster, receiver, random));
    }
}

TEST(CanReach, RangeAndConeEndALight) {
    EXPECT_TRUE(can_reach(lamp({0, 0, 0}, 5.0F), box_at({5.4, 0, 0}, 0.5)));
    EXPECT_FALSE(can_reach(lamp({0, 0, 0}, 5.0F), box_at({6, 0, 0}, 0.5)));

    LightView spot = lamp({0, 0, 0}, 50.0F);
    spot.light.kind = scene::LightKind::spot;
    spot.light.outer_angle = 0.4F;
    spot.direction = {1.0F, 0.0F, 0.0F};
    EXPECT_TRUE(can_reach(spot, box_at({10, 0, 0}, 0.5)));
    EXPECT_FALSE(can_reach(spot, box_at({0, 10, 0}, 0.5)));
}

TEST(FindPairs, NamesTheGroupsThatCanDarkenAReceiver) {
    ShadowScene scene = box_over_floor();
    const auto groups = group_casters(scene, scene.lights[0]);

    const auto pairs = find_pairs(scene, 0, groups);

    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].receiver, 0U);
    EXPECT_EQ(pairs[0].groups, std::vector<std::uint32_t>{0});
}

TEST(FindPairs, LeavesOutWhatTheCameraCannotSee) {
    ShadowScene scene = box_over_floor();
    scene.camera.position = {0.0, 3.0, -50.0}; // looks away
    const auto groups = group_casters(scene, scene.lights[0]);

    EXPECT_TRUE(find_pairs(scene, 0, groups).empty());
}

} // namespace
} // namespace shadows
