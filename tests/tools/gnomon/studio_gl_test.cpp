// One studio draws frame after frame and level after level: what nothing changed is not decided
// anew, and nothing of one level is left in the pictures of the next.

#include "engine/scene/views.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include "tools/gnomon/level.hpp"
#include "tools/gnomon/studio.hpp"

namespace gnomon {
namespace {

constexpr int kSize = 96;

/// A box over a floor.
Level level_with_box(const glm::dvec3& position, const std::string& technique) {
    test_support::WorldBuilder builder = test_support::floor_of(8.0F);
    builder.add("box", scene::make_box(glm::vec3(1.0F)), test_support::at(position));
    builder.add_light(test_support::sun_light());
    Level level;
    level.name = "box";
    level.world = std::move(builder.world);
    level.shadows.scene.technique = technique;
    scene::update(level.world, 0.0F);
    return level;
}

class OneStudio : public testing::Test {
protected:
    void SetUp() override {
        auto opened = Studio::open(kSize, kSize);
        if (!opened) GTEST_SKIP() << "no OpenGL here";
        studio_ = *std::move(opened);
    }

    /// The mask of the only light, after one more frame.
    engine::Image mask(const Level& level) {
        const auto drawn = studio_->draw(level, camera_);
        EXPECT_TRUE(drawn) << engine::to_string(drawn.error());
        return *studio_->mask(0);
    }

    /// Says whether one more frame is planned anew.
    bool plans(const Level& level) {
        const shadows::Plan* before = studio_->shadows().plan().plans.data();
        // What a new plan is made from is allocated before the old one is given back.
        mask(level);
        return studio_->shadows().plan().plans.data() != before;
    }

    std::unique_ptr<Studio> studio_;
    scene::CameraView camera_ = test_support::usual_camera(kSize);
};

TEST_F(OneStudio, DoesNotPlanAnewWhileNothingChanges) {
    const Level level = level_with_box({0.0, 1.0, 0.0}, "auto");
    mask(level);

    EXPECT_FALSE(plans(level));
}

TEST_F(OneStudio, PlansAnewWhenSomethingOfTheFrameChanges) {
    Level level = level_with_box({0.0, 1.0, 0.0}, "auto");
    mask(level);

    camera_.position.x += 0.1;
    EXPECT_TRUE(plans(level)) << "the camera moved";
    level.shadows.scene.error_px = 4.0F;
    EXPECT_TRUE(plans(level)) << "another budget";
    level.world.registry.each<scene::Light>([&](ecs::Entity light, const scene::Light&) {
        level.world.registry.patch<scene::Light>(
            light, [](scene::Light& sun) { sun.angular_radius = 0.01F; });
    });
    EXPECT_TRUE(plans(level)) << "a larger light";
    studio_->shadows().wraps_stencil = !studio_->shadows().wraps_stencil;
    EXPECT_TRUE(plans(level)) << "another driver";
}

TEST_F(OneStudio, TakesNothingOfOneLevelForAnother) {
    for (const std::string technique : {"cascaded_map", "volume", "planar", "traced"}) {
        const Level here = level_with_box({-1.0, 1.0, 0.0}, technique);
        const Level there = level_with_box({1.0, 1.0, 0.0}, technique);
        const engine::Image alone = mask(there);

        mask(here);
        EXPECT_EQ(mask(there).bytes, alone.bytes) << technique;
        EXPECT_NE(mask(here).bytes, alone.bytes) << technique;
    }
}

/// Moves the box.
void step(Level& level) {
    scene::World& world = level.world;
    world.registry.each<scene::Name>([&](ecs::Entity entity, const scene::Name& name) {
        if (name.text == "box")
            world.registry.patch<scene::Transform>(
                entity, [](scene::Transform& place) { place.position.x += 0.05; });
    });
    scene::update(world, 0.0F);
}

TEST_F(OneStudio, RefreshesAMapInEveryFourthFrameWhereThatIsAsked) {
    for (const std::string technique : {"cascaded_map", "shadow_texture"}) {
        Level level = level_with_box({-1.0, 1.0, 0.0}, technique);
        level.shadows.scene.refresh = 4;
        std::vector<std::size_t> refreshes;
        for (int frame = 0; frame < 9; ++frame) {
            mask(level);
            refreshes.push_back(studio_->shadows().refresh_count());
            step(level);
        }
        EXPECT_EQ(refreshes, (std::vector<std::size_t>{1, 0, 0, 0, 1, 0, 0, 0, 1})) << technique;
    }
}

TEST_F(OneStudio, NeverMakesAVolumeWait) {
    Level level = level_with_box({-1.0, 1.0, 0.0}, "volume");
    level.shadows.scene.refresh = 4;
    for (int frame = 0; frame < 4; ++frame) {
        mask(level);
        EXPECT_EQ(studio_->shadows().refresh_count(), 1U);
        step(level);
    }
}

TEST_F(OneStudio, ShowsAMotionThatEndedWhileAMapWaited) {
    Level level = level_with_box({-1.0, 1.0, 0.0}, "cascaded_map");
    level.shadows.scene.refresh = 4;
    mask(level);
    step(level);
    const engine::Image lagging = mask(level);
    for (int frame = 0; frame < 4; ++frame)
        mask(level);
    const engine::Image at_rest = mask(level);
    EXPECT_EQ(studio_->shadows().refresh_count(), 0U);

    studio_->shadows().always_refresh = true;
    EXPECT_EQ(mask(level).bytes, at_rest.bytes);
    EXPECT_NE(lagging.bytes, at_rest.bytes);
}

TEST_F(OneStudio, DrawsAnewWhenARemedyIsSwitched) {
    const Level level = level_with_box({0.0, 1.0, 0.0}, "cascaded_map");
    mask(level);
    mask(level);
    ASSERT_EQ(studio_->shadows().refresh_count(), 0U);

    studio_->shadows().remedies =
        studio_->shadows().remedies.without(shadows::Remedy::map_cascades);
    mask(level);

    EXPECT_EQ(studio_->shadows().refresh_count(), 1U);
}

} // namespace
} // namespace gnomon
