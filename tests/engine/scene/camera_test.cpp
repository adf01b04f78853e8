// Camera views: rays, projection and reversed depth agree with one another.

#include "engine/core/random.hpp"
#include "engine/scene/camera.hpp"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

namespace {

scene::CameraView any_view(engine::Random& random) {
    scene::CameraView view;
    view.position = {
        random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5)};
    const glm::quat rotation = glm::normalize(glm::quat(
        float(random.uniform(-1, 1)),
        float(random.uniform(-1, 1)),
        float(random.uniform(-1, 1)),
        float(random.uniform(-1, 1))));
    view.world_from_view = glm::mat3_cast(rotation);
    view.fov_y = float(random.uniform(0.1, 2.8));
    view.near = float(random.uniform(0.01, 1.0));
    view.width = 16 + int(random.below(2000));
    view.height = 16 + int(random.below(2000));
    return view;
}

TEST(CameraView, ProjectsThePointOfARayOnItsPixel) {
    engine::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const scene::CameraView view = any_view(random);
        const double x = random.uniform(0, view.width);
        const double y = random.uniform(0, view.height);
        const double depth = random.uniform(0.1, 1e4);

        const glm::dvec3 seen = view.project(view.position + depth * view.ray_direction(x, y));

        EXPECT_NEAR(seen.x, x, 1e-2);
        EXPECT_NEAR(seen.y, y, 1e-2);
        EXPECT_NEAR(seen.z, depth, 1e-5 * depth);
    }
}

TEST(CameraView, ClipMatrixGivesTheSamePixelAsProject) {
    engine::Random random(2);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const scene::CameraView view = any_view(random);
        const glm::dvec3 relative =
            random.uniform(1, 100)
            * view.ray_direction(random.uniform(0, view.width), random.uniform(0, view.height));

        const glm::dvec4 clip(view.clip_from_relative() * glm::vec4(glm::vec3(relative), 1.0F));
        const glm::dvec3 seen = view.project(view.position + relative);

        EXPECT_NEAR((clip.x / clip.w * 0.5 + 0.5) * view.width, seen.x, 0.05);
        EXPECT_NEAR((0.5 - clip.y / clip.w * 0.5) * view.height, seen.y, 0.05);
        EXPECT_NEAR(clip.z / clip.w * seen.z, static_cast<double>(view.near), 1e-4);
    }
}

TEST(CameraView, DepthIsOneAtTheNearPlaneAndZeroAtInfinity) {
    scene::CameraView view;
    const glm::vec4 at_near = view.clip_from_view() * glm::vec4(0.0F, 0.0F, -view.near, 1.0F);
    const glm::vec4 at_infinity = view.clip_from_view() * glm::vec4(0.3F, 0.2F, -1.0F, 0.0F);

    EXPECT_FLOAT_EQ(at_near.z / at_near.w, 1.0F);
    EXPECT_EQ(at_infinity.z, 0.0F);
    EXPECT_GT(at_infinity.w, 0.0F);
}

TEST(CameraView, PicturesBeginAtTheTopLeft) {
    const scene::CameraView view;

    const glm::dvec3 top_left = view.ray_direction(0.0, 0.0);

    EXPECT_LT(top_left.x, 0.0);
    EXPECT_GT(top_left.y, 0.0);
    EXPECT_NEAR(top_left.y, std::tan(0.5 * static_cast<double>(view.fov_y)), 1e-6);
    EXPECT_NEAR(top_left.x, -top_left.y * 1280.0 / 720.0, 1e-6);
}

TEST(CameraView, PixelSizeIsTheDistanceOfNeighbouringRays) {
    const scene::CameraView view;
    const glm::dvec3 step = view.ray_direction(100.5, 7.5) - view.ray_direction(100.5, 8.5);

    EXPECT_NEAR(glm::length(step), view.pixel_size(), 1e-9);
}

TEST(CameraView, DepthIsNegativeBehindTheCamera) {
    const scene::CameraView view;

    EXPECT_LT(view.project({0.0, 0.0, 3.0}).z, 0.0);
}

} // namespace
