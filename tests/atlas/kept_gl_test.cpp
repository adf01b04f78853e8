// A planar shadow that is kept in a texture of its floor is drawn once, and again when something
// moves; when it moves all the time it is no longer kept.

#include "tests/atlas/atlas.hpp"
#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include "tools/gnomon/studio.hpp"

namespace atlas {
namespace {

class KeptShadow : public testing::Test {
protected:
    void SetUp() override {
        auto opened = gnomon::Studio::open(kPictureSize, kPictureSize);
        if (!opened) GTEST_SKIP() << "no OpenGL here";
        studio_ = *std::move(opened);
        test_support::WorldBuilder builder = test_support::floor_of(20.0F);
        ball_ = builder.add("ball", scene::make_sphere(0.5F), test_support::at({0.0, 1.5, 0.0}));
        scene::PlacedLight lamp = lamp_at({0.0, 4.0, 1.0});
        lamp.light.radius = 0.4F;
        builder.add_light(lamp);
        stage_ = pinned_stage(
            std::move(builder.world),
            test_support::usual_camera(kPictureSize),
            "lamp",
            "floor",
            "planar");
        stage_.level.shadows.scene.technique = "planar";
        stage_.level.shadows.scene.error_px = 0.5F;
    }

    /// Texels of shadows that one more frame draws.
    std::uint64_t texels() {
        scene::update(stage_.level.world, 0.0F);
        const auto drawn = studio_->draw(stage_.level, stage_.camera);
        EXPECT_TRUE(drawn) << engine::to_string(drawn.error());
        return studio_->renderer().frame().counters().map_texels;
    }

    void move_ball(double by) {
        stage_.level.world.registry.patch<scene::Transform>(
            ball_, [&](scene::Transform& transform) { transform.position.x += by; });
    }

    std::unique_ptr<gnomon::Studio> studio_;
    ecs::Entity ball_;
    Stage stage_;
};

TEST_F(KeptShadow, IsDrawnOnceWhileNothingMoves) {
    EXPECT_GT(texels(), 0U);
    for (int frame = 0; frame < 8; ++frame)
        EXPECT_EQ(texels(), 0U);
}

TEST_F(KeptShadow, IsDrawnAgainWhenItsCasterHasMoved) {
    texels();
    for (int frame = 0; frame < 8; ++frame)
        texels();
    move_ball(0.5);

    EXPECT_GT(texels(), 0U);
    EXPECT_EQ(texels(), 0U);
}

TEST_F(KeptShadow, StaysWhereItIsWhenTheCameraTurns) {
    texels();
    stage_.camera.position.x += 0.5;

    EXPECT_EQ(texels(), 0U);
}

TEST_F(KeptShadow, IsNotKeptWhileItsCasterMovesInEveryFrame) {
    texels();
    for (int frame = 0; frame < 3; ++frame) {
        move_ball(0.02);
        texels();
    }
    for (int frame = 0; frame < 8; ++frame) {
        move_ball(0.02);
        EXPECT_EQ(texels(), 0U);
    }
    for (int frame = 0; frame < 20; ++frame)
        texels();
    EXPECT_EQ(texels(), 0U);
    move_ball(0.02);
    EXPECT_GT(texels(), 0U) << "it stood still and was kept again";
}

} // namespace
} // namespace atlas
