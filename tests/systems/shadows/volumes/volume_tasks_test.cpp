#include "systems/shadows/snapshot.hpp"
#include "systems/shadows/volumes/volume_tasks.hpp"
#include "tests/support/worlds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shadows {
namespace {

using test_support::at;
using testing::ElementsAre;

/// Two rings over a floor, one beside the other, of one mesh with proxies.
struct VolumeTasks : testing::Test {
    test_support::WorldBuilder builder = test_support::floor_of(20.0F);
    ShadowScene scene;
    std::vector<CasterGroup> groups;
    std::vector<Plan> plans;
    scene::ShadowWish wish;
    Remedies remedies;

    VolumeTasks() {
        scene::Mesh ring = scene::make_torus(1.0F, 0.35F);
        ring.proxies = scene::make_proxies(ring);
        builder.add("ring a", std::move(ring), at({-2.0, 2.0, 0.0}));
        builder.add_instance("ring b", 1, at({2.0, 2.0, 0.0}));
        scene::update(builder.world, 0.0F);
        scene = take_snapshot(
            builder.world,
            scene::ReceiverTable(builder.world),
            test_support::usual_camera(256),
            std::vector{test_support::sun_along({1.0, -0.2, 0.0})});
        for (std::uint32_t caster = 0; caster < scene.casters.size(); ++caster)
            groups.push_back({{caster}, scene.casters[caster].bounds, 0.0, false, 0});
    }

    /// A receiver's plan: each named caster with its level.
    void plan(
        const std::string& receiver,
        const std::vector<std::pair<std::string, std::uint8_t>>& casters) {
        Plan made;
        made.receiver = id(receiver);
        PlanEntry entry{"volume", {}, {}};
        for (const auto& [name, level] : casters) {
            for (std::uint32_t i = 0; i < scene.casters.size(); ++i)
                if (scene.casters[i].name == name) entry.caster_groups.push_back(i);
            entry.predicted.proxy_levels.push_back(level);
        }
        made.entries.push_back(entry);
        plans.push_back(made);
    }

    [[nodiscard]] std::uint32_t id(const std::string& receiver) const {
        for (const ReceiverView& view : scene.receivers)
            if (view.name == receiver || view.name == receiver + "#1") return view.id;
        ADD_FAILURE() << receiver;
        return 0;
    }

    [[nodiscard]] std::vector<VolumePass> passes() const {
        std::vector<const Plan*> pointers;
        for (const Plan& one : plans)
            pointers.push_back(&one);
        const std::function<const trace::TraceScene&()> truth;
        return volume_passes(
            {builder.world, scene, 0, groups, pointers, 100, true, wish, remedies, truth});
    }
};

TEST_F(VolumeTasks, AProxyDarkensTheFloorAndTheMeshItself) {
    wish.proxy = 1;
    plan("floor", {{"ring a", 1}});
    plan("ring a", {{"ring a", 0}});

    const auto made = passes();

    ASSERT_EQ(made.size(), 2U);
    EXPECT_THAT(made[0].receivers, ElementsAre(id("ring a")));
    EXPECT_EQ(made[0].tasks[0].level, 0);
    EXPECT_THAT(made[1].receivers, ElementsAre(id("floor")));
    EXPECT_EQ(made[1].tasks[0].level, 1);
}

TEST_F(VolumeTasks, ACasterThatIsDrawnAnywayNeedsNoProxy) {
    plan("floor", {{"ring a", 1}});
    plan("ring a", {{"ring a", 0}});

    const auto made = passes();

    ASSERT_EQ(made.size(), 1U);
    ASSERT_EQ(made[0].tasks.size(), 1U);
    EXPECT_EQ(made[0].tasks[0].level, 0);
    EXPECT_EQ(made[0].receivers.size(), 2U);
}

TEST_F(VolumeTasks, ProxiesOfSeveralCastersAreCountedTogether) {
    plan("floor", {{"ring a", 1}, {"ring b", 2}});

    const auto made = passes();

    ASSERT_EQ(made.size(), 2U);
    EXPECT_EQ(made[1].tasks.size(), 2U);
}

TEST_F(VolumeTasks, AProxyIsCountedApartFromOneThatDarkensItsMesh) {
    wish.proxy = 1;
    plan("floor", {{"ring a", 1}, {"ring b", 1}});
    plan("ring b", {{"ring a", 1}, {"ring b", 0}});

    for (const VolumePass& pass : passes())
        for (const VolumeTask& task : pass.tasks)
            for (const std::uint32_t receiver : pass.receivers)
                EXPECT_FALSE(
                    task.level > 0 && scene.casters[task.caster].name == "ring b"
                    && receiver == id("ring b"));
    EXPECT_EQ(passes().size(), 3U);
}

TEST_F(VolumeTasks, WithoutTheRemedyOneVolumeServesAll) {
    plan("floor", {{"ring a", 1}});
    plan("ring a", {{"ring a", 0}});
    remedies = remedies.without(Remedy::volume_own_surface);

    const auto made = passes();

    ASSERT_EQ(made.size(), 1U);
    ASSERT_EQ(made[0].tasks.size(), 1U);
    EXPECT_EQ(made[0].tasks[0].level, 1);
    EXPECT_EQ(made[0].receivers.size(), 2U);
}

} // namespace
} // namespace shadows
