#include "engine/core/random.hpp"
#include "systems/shadows/caster_groups.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

namespace shadows {
namespace {

ShadowScene crowd(std::size_t count, std::size_t heroes) {
    engine::Random random(3);
    ShadowScene scene;
    scene.lights = {sun()};
    for (std::size_t i = 0; i < count; ++i)
        scene.casters.push_back(caster_at(
            fmt::format("caster {:05}", i),
            {random.uniform(-50, 50), 1.0, random.uniform(-50, 50)},
            0.5,
            i < heroes));
    return scene;
}

std::set<std::uint32_t> members(const std::vector<CasterGroup>& groups) {
    std::set<std::uint32_t> all;
    for (const CasterGroup& group : groups)
        for (const std::uint32_t caster : group.casters)
            EXPECT_TRUE(all.insert(caster).second) << "caster " << caster << " is in two groups";
    return all;
}

TEST(CasterGroups, EveryCasterIsInExactlyOneGroup) {
    const ShadowScene scene = crowd(1000, 5);

    EXPECT_EQ(members(group_casters(scene, scene.lights[0])).size(), 1000U);
}

TEST(CasterGroups, HeroesStandAlone) {
    const ShadowScene scene = crowd(100, 3);

    const auto groups = group_casters(scene, scene.lights[0]);

    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(groups[i].hero);
        EXPECT_EQ(groups[i].casters.size(), 1U);
    }
    EXPECT_FALSE(groups[3].hero);
}

TEST(CasterGroups, ThereAreNeverMoreThanTheLimit) {
    for (const std::size_t heroes : {0U, 63U, 64U, 65U, 500U}) {
        SCOPED_TRACE(heroes);
        const ShadowScene scene = crowd(3000, heroes);

        const auto groups = group_casters(scene, scene.lights[0]);

        EXPECT_LE(groups.size(), kMaxGroupsPerLight);
        EXPECT_EQ(members(groups).size(), 3000U);
    }
}

TEST(CasterGroups, NeighboursShareAGroup) {
    const ShadowScene scene = crowd(1000, 0);

    const auto groups = group_casters(scene, scene.lights[0]);

    ASSERT_GT(groups.size(), 16U);
    for (const CasterGroup& group : groups) {
        const glm::dvec3 extent = group.bounds.extent();
        EXPECT_LT(extent.x * extent.z, 100.0 * 100.0 / 8.0);
    }
}

TEST(CasterGroups, CastersOutOfALampsReachAreLeftOut) {
    ShadowScene scene = crowd(100, 0);
    scene.lights = {lamp({0, 2, 0}, 10.0F)};

    const auto groups = group_casters(scene, scene.lights[0]);

    for (const std::uint32_t caster : members(groups))
        EXPECT_LT(glm::length(scene.casters[caster].bounds.centre() - glm::dvec3(0, 2, 0)), 11.0);
}

} // namespace
} // namespace shadows
