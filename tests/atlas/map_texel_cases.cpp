// Failures of texels that are too few where they are seen.
//
// Sources: M. Stamminger and G. Drettakis, "Perspective Shadow Maps", 2002 (perspective and
// projective aliasing); F. Zhang et al., "Parallel-Split Shadow Maps", 2006 (cascades).

#include "tests/atlas/map_stage.hpp"

#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::camera_looking;
using test_support::floor_of;
using test_support::sun_along;
using test_support::sun_at;
using test_support::usual_camera;
using test_support::WorldBuilder;

/// Two rows of posts from the camera to the horizon.
Stage avenue(double eye) {
    WorldBuilder builder = floor_of(200.0F);
    builder.add("post", scene::make_box({0.2F, 1.2F, 0.2F}), at({-1.0, 0.6, 6.5}));
    for (int i = 1; i < 100; ++i)
        builder.add_instance(
            "post" + std::to_string(i),
            1,
            at({i % 2 == 0 ? -1.0 : 1.0, 0.6, 6.5 - 1.2 * static_cast<double>(i)}));
    builder.add_light(sun_at(50.0, 25.0));
    Stage stage = one_map(
        builder,
        camera_looking({0.0, eye, 8.0}, {0.0, 0.2, 0.0}, kPictureSize, kPictureSize),
        "sun",
        "floor",
        "cascaded_map",
        512);
    stage.level.shadows.scene.cascades = std::nullopt;
    return stage;
}

/// A ball before a wall that the sun lights at an angle to its normal.
Stage grazed_wall(double angle_deg) {
    const double angle = glm::radians(angle_deg);
    const glm::dvec3 way =
        glm::normalize(glm::dvec3(std::sin(angle), -0.2, -std::cos(angle) - 1e-9));
    WorldBuilder builder = floor_of(20.0F);
    builder.add("wall", scene::make_box({8.0F, 4.0F, 0.2F}), at({0.0, 2.0, -0.1}));
    builder.add(
        "ball",
        scene::make_sphere(0.4F),
        at(glm::dvec3(0.0, 1.4, 0.0) - way * 0.6 / std::max(-way.z, 0.15)));
    builder.add_light(sun_along(way));
    Stage stage = one_map(
        builder,
        camera_looking({0.0, 1.6, 5.0}, {0.0, 1.4, 0.0}, kPictureSize, kPictureSize),
        "sun",
        "wall",
        "cascaded_map",
        1024);
    stage.level.shadows.receivers["floor"].technique = "cascaded_map";
    return stage;
}

/// Stones all round: a map has to reach them.
void scatter_stones(WorldBuilder& builder) {
    const auto mesh = static_cast<std::uint32_t>(builder.world.assets.meshes.size());
    builder.add("stone", scene::make_box(glm::vec3(0.5F)), at({-25.0, 0.25, -25.0}));
    builder.add_instance("stone east", mesh, at({25.0, 0.25, -20.0}));
    builder.add_instance("stone south", mesh, at({20.0, 0.25, 25.0}));
    builder.add_instance("stone west", mesh, at({-25.0, 0.25, 20.0}));
}

/// The sun turns by less than a texel: the whole grid turns with it.
Stage turning_sun(double turned) {
    WorldBuilder builder = floor_of(60.0F);
    scatter_stones(builder);
    builder.add("ball", scene::make_sphere(0.6F), at({-1.0, 1.6, 0.0}));
    builder.add("box", scene::make_box(glm::vec3(1.0F)), at({1.2, 0.5, 0.5}));
    builder.add_light(sun_at(40.0, 35.0 + turned));
    Stage stage = one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 0);
    stage.level.shadows.scene.map_size = std::nullopt;
    return stage;
}

/// Bars about a pixel and a half wide, by a designer who accepts a fifth of a pixel.
Stage fence(double radius) {
    WorldBuilder builder = floor_of(60.0F);
    const auto r = static_cast<float>(radius);
    builder.add("bar", scene::make_box({2.0F * r, 1.0F, 2.0F * r}), at({-1.5, 0.5, 0.0}));
    for (int i = 1; i < 12; ++i)
        builder.add_instance("bar" + std::to_string(i), 1, at({-1.5 + 0.25 * i, 0.5, 0.0}));
    scatter_stones(builder);
    builder.add_light(sun_at(40.0, 75.0));
    Stage stage = one_map(
        builder,
        camera_looking({0.0, 2.2, 3.4}, {0.2, 0.0, 0.6}, kPictureSize, kPictureSize),
        "sun",
        "floor",
        "cascaded_map",
        0);
    stage.level.shadows.scene.map_size = std::nullopt;
    stage.level.shadows.scene.error_px = 0.2F;
    return stage;
}

} // namespace

std::vector<Case> map_texel_cases() {
    return {
        {"M4",
         "one map for near and far makes stairs before the camera",
         avenue,
         {0.5, 2.5, 1.0},
         Remedy::map_cascades,
         {eps_at_most(0.6)}},
        {"M5",
         "a wall that the light grazes is streaked",
         grazed_wall,
         {0.0, 88.0, 80.0},
         Remedy::map_receiver_plane,
         right_beyond_texels()},
        {"M21",
         "as the sun turns by less than a texel, edges crawl by one",
         turning_sun,
         {0.0, 0.8, 0.4},
         Remedy::map_needed_texels,
         {eps_at_most(0.5)}},
        {"M26",
         "thin bars throw dashes",
         fence,
         {0.008, 0.03, 0.01},
         Remedy::map_needed_texels,
         {lit_share_of_shadow(0.35)}},
    };
}

} // namespace atlas
