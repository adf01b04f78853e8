// Failures of the ways in which a receiver's depth is compared with a map's.
//
// Sources: J. Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", GDC 2006, and C. Schueler,
// "Eliminating Surface Acne with Gradient Shadow Mapping", ShaderX4 (planes from derivatives);
// D. Holbert, "Saying Goodbye to Shadow Acne", GDC 2011 (normal offsets).

#include "tests/atlas/map_stage.hpp"

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::camera_looking;
using test_support::floor_of;
using test_support::sun_at;
using test_support::usual_camera;
using test_support::WorldBuilder;

/// A floor over another one, read by a filter that is four texels wide.
Stage floor_under_wide_filter(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("basement", scene::make_plane(glm::vec2(200.0F)), at({0.0, -3.0, 0.0}));
    builder.add_light(sun_at(elevation, 35.0));
    Stage stage = one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 512);
    stage.level.shadows.receivers["basement"].technique = "cascaded_map";
    stage.level.shadows.scene.filter = "pcf";
    return stage;
}

/// Posts a few pixels wide: outlines everywhere.
Stage lit_posts(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("post/0", scene::make_box({0.06F, 1.6F, 0.06F}), at({-2.0, 0.8, 0.0}));
    for (int i = 1; i < 24; ++i)
        builder.add_instance(
            "post/" + std::to_string(i), 1, at({-2.0 + 0.17 * i, 0.8, i % 2 == 0 ? 0.0 : 0.6}));
    builder.add_light(sun_at(elevation, 235.0));
    Stage stage = one_map(
        builder,
        camera_looking({0.0, 2.0, 4.0}, {0.0, 0.8, 0.0}, kPictureSize, kPictureSize),
        "sun",
        "post",
        "cascaded_map",
        1024);
    stage.level.shadows.receivers["floor"].technique = "cascaded_map";
    return stage;
}

/// A wall whose shadow's end moves when look-ups do.
Stage wall_and_corner(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("wall", scene::make_box({4.0F, 1.0F, 0.05F}), at({0.0, 0.5, 0.0}));
    builder.add_light(sun_at(elevation, 90.0));
    return one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 256);
}

} // namespace

std::vector<Case> map_bias_cases() {
    return {
        {"M14",
         "a bias that suits one texel lets stripes come back under a wide filter",
         floor_under_wide_filter,
         {8.0, 85.0, 15.0},
         Remedy::map_kernel_plane,
         {dimmed_at_most(0.0, 0.95)}},
        {"M15",
         "planes from neighbouring pixels leave specks along every outline",
         lit_posts,
         {30.0, 60.0, 45.0},
         Remedy::map_exact_facets,
         right_beyond_texels()},
        {"M16",
         "look-ups moved along the normal move every edge",
         wall_and_corner,
         {20.0, 60.0, 25.0},
         Remedy::map_no_normal_offset,
         right_beyond_texels()},
    };
}

} // namespace atlas
