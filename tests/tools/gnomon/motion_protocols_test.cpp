#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tools/gnomon/motion_protocols.hpp"

namespace gnomon {
namespace {

scene::CameraView start() {
    scene::CameraView camera;
    camera.position = {1.0, 2.0, 3.0};
    return camera;
}

TEST(MotionProtocols, BeginWithTheStillOneAndHaveNoNameTwice) {
    const auto names = protocol_names();

    ASSERT_FALSE(names.empty());
    EXPECT_EQ(names.front(), "still");
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_EQ(std::count(names.begin(), names.end(), names[i]), 1) << names[i];
}

TEST(MotionProtocols, TheFirstFrameIsTheCameraAsItWas) {
    for (const Protocol& protocol : protocols()) {
        SCOPED_TRACE(protocol.name);
        const scene::CameraView camera = camera_at(protocol.name, start(), 0, 64);

        EXPECT_EQ(camera.position, start().position);
        EXPECT_EQ(camera.world_from_view, start().world_from_view);
        EXPECT_EQ(camera.fov_y, start().fov_y);
    }
}

TEST(MotionProtocols, AWalkOfASecondCoversOnePointFourMetresOnTheLevel) {
    const scene::CameraView camera = camera_at("walk", start(), 60, 64);

    EXPECT_NEAR(glm::length(camera.position - start().position), 1.4, 1e-12);
    EXPECT_EQ(camera.position.y, start().position.y);
    EXPECT_LT(camera.position.z, start().position.z) << "it looks along -Z";
}

TEST(MotionProtocols, AYawOfNinetyFramesLooksToTheLeft) {
    const scene::CameraView camera = camera_at("yaw", start(), 90, 91);
    const glm::vec3 forward = -camera.world_from_view[2];

    EXPECT_NEAR(forward.x, -1.0F, 1e-5F);
    EXPECT_NEAR(forward.z, 0.0F, 1e-5F);
}

TEST(MotionProtocols, AZoomEndsAtFiveSixthsOfTheAngle) {
    scene::CameraView wide = start();
    wide.fov_y = std::numbers::pi_v<float> / 3.0F;

    const scene::CameraView end = camera_at("zoom", wide, 63, 64);

    EXPECT_NEAR(end.fov_y * 180.0F / std::numbers::pi_v<float>, 50.0F, 1e-4F);
}

TEST(MotionProtocols, OnlyThoseThatSayThatTheyMoveTheCameraDo) {
    for (const Protocol& protocol : protocols()) {
        SCOPED_TRACE(protocol.name);
        const scene::CameraView camera = camera_at(protocol.name, start(), 5, 64);
        const bool moved = camera.position != start().position
                           || camera.world_from_view != start().world_from_view
                           || camera.fov_y != start().fov_y;

        EXPECT_EQ(moved, protocol.moves_camera);
    }
}

} // namespace
} // namespace gnomon
