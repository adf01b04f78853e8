// Failures of shadow maps.
//
// Sources: L. Williams, "Casting Curved Shadows on Curved Surfaces", 1978 (bias); H. Dou et al.,
// "Adaptive Depth Bias for Shadow Maps", JCGT 2014; M. Valient, ShaderX6.
//
// What maps keep of a depth, how they compare it and how large their texels are: map_depth_cases,
// map_bias_cases, map_texel_cases. Crawling and flickering: map_motion_cases.

#include "tests/atlas/map_stage.hpp"
#include "tests/support/worlds.hpp"

#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::camera_looking;
using test_support::floor_of;
using test_support::sun_at;
using test_support::usual_camera;
using test_support::WorldBuilder;

/// The floor of an upper storey under a low sun: it darkens the storey below, so the map holds it.
Stage slanted_floor(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("basement", scene::make_plane(glm::vec2(200.0F)), at({0.0, -3.0, 0.0}));
    builder.add_light(sun_at(elevation, 35.0));
    Stage stage = one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 512);
    stage.level.shadows.receivers["basement"].technique = "cascaded_map";
    return stage;
}

/// A ring: a receiver that slants in every direction at once.
Stage lit_ring(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ring", scene::make_torus(1.6F, 0.7F), at({0.0, 0.7, 0.0}));
    builder.add_light(sun_at(elevation, 230.0));
    return one_map(builder, usual_camera(kPictureSize), "sun", "ring", "cascaded_map", 512);
}

/// A thin wall on the ground: any bias lets light in under it.
Stage wall_on_ground(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("wall", scene::make_box({4.0F, 1.0F, 0.05F}), at({0.0, 0.5, 0.0}));
    builder.add_light(sun_at(elevation, 90.0));
    return one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 2048);
}

/// A tower that reaches far above everything that receives.
Stage tall_tower(double height) {
    WorldBuilder builder = floor_of(20.0F);
    const ecs::Entity tower = builder.add(
        "tower",
        scene::make_box({1.0F, static_cast<float>(height), 1.0F}),
        at({-2.0, height * 0.5, 0.0}));
    builder.world.registry.patch<scene::ShadowRole>(
        tower, [](scene::ShadowRole& role) { role.receives = false; });
    builder.add_light(sun_at(60.0, 20.0));
    return one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 1024);
}

/// A table under the line where two faces of a cube map meet.
Stage table_on_seam(double turn) {
    WorldBuilder builder = floor_of(12.0F);
    // Over the table the faces -x, -y and -z of cube_turn() meet.
    const double angle = glm::radians(225.0 + turn);
    builder.add(
        "table",
        scene::make_box({1.6F, 0.1F, 1.6F}),
        at({1.7 * std::cos(angle), 1.0, 1.7 * std::sin(angle)}));
    builder.add_light(test_support::lamp_light("lamp", {0.0, 2.3, 0.0}, 50.0F, 30.0F));
    Stage stage = one_map(
        builder,
        camera_looking({-5.0, 5.0, -5.5}, {-2.2, 0.0, -2.2}, kPictureSize, kPictureSize),
        "lamp",
        "floor",
        "cube_map",
        96);
    stage.level.shadows.scene.filter = "pcf";
    return stage;
}

/// A lamp in a corner: everything is lit, and the map's filters see both walls and the floor.
Stage lit_corner(double height) {
    WorldBuilder builder = floor_of(12.0F);
    builder.add("north", scene::make_box({8.0F, 4.0F, 0.4F}), at({0.0, 2.0, -2.2}));
    builder.add("west", scene::make_box({0.4F, 4.0F, 8.0F}), at({-2.2, 2.0, 0.0}));
    builder.add_light(test_support::lamp_light("lamp", {0.3, height, 0.6}, 50.0F, 30.0F));
    Stage stage = one_map(
        builder,
        camera_looking({3.0, 2.5, 3.5}, {-1.5, 0.6, -1.5}, kPictureSize, kPictureSize),
        "lamp",
        "floor",
        "cube_map",
        128);
    stage.level.shadows.scene.filter = "pcf";
    return stage;
}

/// A tower behind the camera whose shadow falls into view.
Stage tower_behind(double distance) {
    WorldBuilder builder = floor_of(60.0F);
    builder.add("tower", scene::make_box({1.0F, 8.0F, 1.0F}), at({0.0, 4.0, 8.0 + distance}));
    builder.add("stone", scene::make_box(glm::vec3(0.4F)), at({2.5, 0.2, 0.0}));
    builder.add_light(sun_at(30.0, 270.0));
    return one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 2048);
}

/// A high roof whose shadow's edge runs from one cascade into the next, as a camera walks along it.
Stage roof_over_seams(double walked) {
    WorldBuilder builder = floor_of(200.0F);
    builder.add("roof", scene::make_box({20.0F, 0.1F, 160.0F}), at({-15.0, 6.0, 0.0}));
    builder.add_light(sun_at(50.0, 25.0));
    scene::CameraView camera = camera_looking(
        {0.0, 2.5, 8.0 - walked}, {0.0, 0.0, 2.5 - walked}, kPictureSize, kPictureSize);
    camera.fov_y = glm::radians(40.0F);
    Stage stage = one_map(builder, camera, "sun", "floor", "cascaded_map", 128);
    stage.level.shadows.scene.cascades = 3;
    stage.level.shadows.scene.filter = "pcf";
    return stage;
}

/// How much more the mask changes between two neighbours than the truth does.
double largest_step(const measure::Comparison& comparison) {
    const measure::Mask& drawn = comparison.measured;
    double largest = 0.0;
    const auto step = [&](std::size_t i, std::size_t j) {
        if (comparison.kind[i] != measure::PixelKind::valid) return;
        if (comparison.kind[j] != measure::PixelKind::valid) return;
        const float true_step = comparison.truth.visibility[i] - comparison.truth.visibility[j];
        const float drawn_step = drawn.visibility[i] - drawn.visibility[j];
        largest =
            std::max(largest, static_cast<double>(std::abs(drawn_step) - std::abs(true_step)));
    };
    for (int y = 0; y + 1 < drawn.height; ++y)
        for (int x = 0; x + 1 < drawn.width; ++x) {
            step(drawn.index(x, y), drawn.index(x + 1, y));
            step(drawn.index(x, y), drawn.index(x, y + 1));
        }
    return largest;
}

Gate step_at_most(double visibility) {
    return {
        "step between neighbours that truth has not",
        [](const Observation& seen) { return largest_step(seen.comparison); },
        visibility};
}

} // namespace

std::vector<Case> map_cases() {
    return {
        {"M1",
         "a slanted floor shadows itself in stripes",
         slanted_floor,
         {5.0, 85.0, 10.0},
         Remedy::map_receiver_plane,
         {false_shadow_at_most(0.0)}},
        {"M1curved",
         "a ring shadows itself in stripes",
         lit_ring,
         {30.0, 75.0, 45.0},
         Remedy::map_receiver_plane,
         {largest_error_inside(12.0), false_shadow_at_most(40.0)}},
        {"M2",
         "light passes under a wall that stands on the ground",
         wall_on_ground,
         {25.0, 65.0, 45.0},
         Remedy::map_no_constant_bias,
         {light_leak_at_most(0.0)}},
        {"M7",
         "a tower above the map's near plane is cut off",
         tall_tower,
         {5.0, 40.0, 40.0},
         Remedy::map_pancaking,
         {light_leak_at_most(0.0), false_shadow_at_most(0.0)}},
        {"M11",
         "lines along the seams of a cube map",
         table_on_seam,
         {-10.0, 10.0, 0.0},
         Remedy::map_padded_faces,
         right_beyond_texels()},
        {"M18",
         "a soft edge changes its width at once where a cascade ends",
         roof_over_seams,
         {0.0, 0.8, 0.4}, // steps of 20 cm
         Remedy::map_blended_seams,
         // Widths differ by a factor of four, so the sudden step is 0.3; the edge itself is a ramp
         // of 0.1 a pixel, with stairs as deep as a texel, which covers 60 px.
         {step_at_most(0.2), largest_error_inside(64.0)}},
        {"Corner",
         "dark dashes along lit corners",
         lit_corner,
         {1.0, 3.0, 2.0},
         Remedy::map_open_creases,
         {dimmed_at_most(0.0)}},
        {"M25",
         "a tower behind the camera throws no shadow into view",
         tower_behind,
         {1.0, 5.0, 3.0},
         Remedy::map_swept_casters,
         {light_leak_at_most(0.0)}},
    };
}

} // namespace atlas
