#include "systems/shadows/screen_bounds.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

/// At the origin, looks along -Z.
scene::CameraView plain_camera() {
    scene::CameraView view = camera();
    view.position = {};
    return view;
}

TEST(ScreenBounds, HoldEveryCornerAndNoMore) {
    const scene::CameraView view = plain_camera();
    const engine::WorldAabb box{{-1.0, 0.0, -6.0}, {1.0, 2.0, -5.0}};

    const PixelBox found = screen_bounds(view, box);

    const glm::dvec3 low = view.project({-1.0, 0.0, -5.0});
    const glm::dvec3 high = view.project({1.0, 2.0, -5.0});
    EXPECT_EQ(found.left, static_cast<int>(std::floor(low.x)));
    EXPECT_EQ(found.right, static_cast<int>(std::ceil(high.x)));
    EXPECT_EQ(found.bottom, static_cast<int>(std::floor(512.0 - low.y)));
    EXPECT_EQ(found.top, static_cast<int>(std::ceil(512.0 - high.y)));
}

TEST(ScreenBounds, AreEmptyBehindTheCamera) {
    EXPECT_TRUE(screen_bounds(plain_camera(), box_at({0.0, 0.0, 5.0}, 1.0)).empty());
}

TEST(ScreenBounds, AreEmptyBesideThePicture) {
    EXPECT_TRUE(screen_bounds(plain_camera(), box_at({50.0, 0.0, -5.0}, 1.0)).empty());
}

TEST(ScreenBounds, AreThePictureForABoxRoundTheCamera) {
    EXPECT_EQ(screen_bounds(plain_camera(), box_at({}, 1.0)), (PixelBox{0, 0, 512, 512}));
}

TEST(ScreenBounds, ReachTheBorderWhereAFloorPassesUnderTheCamera) {
    const engine::WorldAabb floor{{-50.0, -1.0, -50.0}, {50.0, -1.0, 50.0}};

    const PixelBox found = screen_bounds(plain_camera(), floor);

    EXPECT_EQ(found.bottom, 0);
    EXPECT_EQ(found.left, 0);
    EXPECT_EQ(found.right, 512);
    EXPECT_LT(found.top, 260);
    EXPECT_GT(found.top, 230);
}

TEST(ScreenBounds, OfAnEmptyBoxAreEmpty) {
    EXPECT_TRUE(screen_bounds(plain_camera(), {}).empty());
}

} // namespace
} // namespace shadows
