#include "engine/scene/framing.hpp"
#include "systems/shadows/maps/map_resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shadows {
namespace {

constexpr double kTexel = 0.05; // metres
constexpr double kReach = 1.0;  // texels

glm::dmat3 axes_along(const glm::dvec3& forward, const glm::dvec3& right) {
    return glm::transpose(glm::dmat3(right, glm::cross(right, forward), forward));
}

/// Looks straight down from 10 m.
scene::CameraView from_above() {
    scene::CameraView camera;
    camera.position = {0.0, 10.0, 0.0};
    camera.world_from_view = glm::mat3_cast(scene::rotation_along({0.0F, -1.0F, 0.0F}));
    return camera;
}

/// A sun whose light goes to the right, `angle` off the vertical.
ParallelView sun_view(double angle) {
    ParallelView view;
    view.light_from_world = axes_along({std::sin(angle), -std::cos(angle), 0.0}, {0.0, 0.0, 1.0});
    view.min = glm::dvec2(-10.0);
    view.texel = glm::dvec2(kTexel);
    view.size = 400;
    return view;
}

const SurfacePoint kFloor{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

TEST(MapResolution, OfASunOverheadIsATexelInPixels) {
    const scene::CameraView camera = from_above();

    const Resolution seen = on_screen(camera, kFloor, texel_at(sun_view(0.0), kFloor, kReach));

    EXPECT_NEAR(seen.texel_px, kTexel / (10.0 * camera.pixel_size()), 1e-4);
    EXPECT_NEAR(seen.shift_px, 0.0, 1e-9); // raised straight up: the edge stays below
}

TEST(MapResolution, GrowsWithTheCosineOfTheSunsAngle) {
    const scene::CameraView camera = from_above();
    const double angle = 1.2;

    const Resolution seen = on_screen(camera, kFloor, texel_at(sun_view(angle), kFloor, kReach));

    const double texel_px = kTexel / (10.0 * camera.pixel_size());
    EXPECT_NEAR(seen.texel_px, texel_px / std::cos(angle), 1e-4);
    // What is forgiven, along the light, as it is seen on the floor: a quarter of a texel and of
    // its slope, and two texels per texel of the filter's reach.
    const double forgiven = 0.25 * (1.0 + std::tan(angle)) + 2.0 * kReach;
    EXPECT_NEAR(seen.shift_px, forgiven * texel_px * std::sin(angle), 1e-4);
}

TEST(MapResolution, TakesTheWayInWhichTheTexelIsLargest) {
    // A texel three times as long as wide, turned by half a right angle on screen.
    ParallelView view = sun_view(0.0);
    view.light_from_world = axes_along({0.0, -1.0, 0.0}, glm::normalize(glm::dvec3(1.0, 0.0, 1.0)));
    view.texel = {3.0 * kTexel, kTexel};
    const scene::CameraView camera = from_above();

    const Resolution seen = on_screen(camera, kFloor, texel_at(view, kFloor, kReach));

    EXPECT_NEAR(seen.texel_px, 3.0 * kTexel / (10.0 * camera.pixel_size()), 1e-4);
}

TEST(MapResolution, ShrinksWhereTheCameraSeesTheFloorAtASlant) {
    // 45 degrees down: across the view nothing is foreshortened, and that way counts.
    scene::CameraView camera = from_above();
    camera.position = {0.0, 10.0, 10.0};
    camera.world_from_view = glm::mat3_cast(scene::rotation_along({0.0F, -1.0F, -1.0F}));
    const double pixel = std::sqrt(200.0) * camera.pixel_size();

    const Resolution seen = on_screen(camera, kFloor, texel_at(sun_view(0.0), kFloor, kReach));

    EXPECT_NEAR(seen.texel_px, kTexel / pixel, 1e-4);
}

TEST(MapResolution, OfALampGrowsWithTheDistance) {
    PyramidView lamp;
    lamp.position = {0.0, 4.0, 0.0};
    lamp.light_from_world = axes_along({0.0, -1.0, 0.0}, {1.0, 0.0, 0.0});
    lamp.size = 256; // 90 degrees wide: 2 metres per metre of distance
    const scene::CameraView camera = from_above();
    const double texel_px = 2.0 * 4.0 / 256.0 / (10.0 * camera.pixel_size());

    const Resolution below = on_screen(camera, kFloor, texel_at(lamp, kFloor, kReach));
    // Texels of a flat window lie as densely on a parallel plane everywhere.
    const SurfacePoint aside{{3.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
    const Resolution there = on_screen(camera, aside, texel_at(lamp, aside, kReach));

    EXPECT_NEAR(below.texel_px, texel_px, 1e-4);
    EXPECT_NEAR(there.texel_px, texel_px, 1e-4);
    EXPECT_GT(there.shift_px, 0.0);
}

/// Neighbouring texels' rays, met with the surface, are where the steps say.
TEST(MapResolution, StepsLeadToWhereTheNextTexelFalls) {
    PyramidView lamp;
    lamp.position = {0.5, 4.0, -0.3};
    lamp.light_from_world = axes_along({0.0, -1.0, 0.0}, {1.0, 0.0, 0.0});
    lamp.size = 4096;
    const SurfacePoint point{{1.0, 0.5, 0.7}, glm::normalize(glm::dvec3(0.3, 1.0, -0.2))};

    const TexelOnSurface texel = texel_at(lamp, point, kReach);

    const auto texel_of = [&](const glm::dvec3& position) {
        const glm::dvec4 map = lamp.map_from_world() * glm::dvec4(position, 1.0);
        return glm::dvec2(map) / map.w * static_cast<double>(lamp.size);
    };
    const glm::dvec2 here = texel_of(point.position);
    EXPECT_NEAR(glm::dot(texel.right, point.normal), 0.0, 1e-12);
    EXPECT_NEAR(
        glm::length(texel_of(point.position + texel.right) - here - glm::dvec2(1, 0)), 0.0, 1e-3);
    EXPECT_NEAR(
        glm::length(texel_of(point.position + texel.up) - here - glm::dvec2(0, 1)), 0.0, 1e-3);
}

} // namespace
} // namespace shadows
