// Failures of what a map keeps: which side of a caster, in how many bits, and what it does with
// casters nearer to the light than it reaches.
//
// Sources: L. Williams, "Casting Curved Shadows on Curved Surfaces", 1978 (bits of depth); Y. Wang
// and S. Molnar, "Second-Depth Shadow Mapping", 1994 (the far side of casters).

#include "tests/atlas/map_stage.hpp"

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

/// An awning of one sheet.
Stage sheet_over_floor(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("awning", scene::make_plane(glm::vec2(2.0F)), at({0.0, height, 0.0}));
    builder.add_light(sun_at(55.0, 40.0));
    return one_map(builder, usual_camera(kPictureSize), "sun", "floor", "cascaded_map", 1024);
}

/// A board that lies on the floor, under a tower that makes the map deep.
Stage low_board(double thickness) {
    WorldBuilder builder = floor_of(60.0F);
    builder.add(
        "board",
        scene::make_box({2.0F, static_cast<float>(thickness), 2.0F}),
        at({0.0, thickness * 0.5, 0.0}));
    builder.add_light(sun_at(25.0, 40.0));
    return one_map(
        builder,
        camera_looking({0.0, 2.5, 3.0}, {0.3, 0.0, 0.0}, kPictureSize, kPictureSize),
        "sun",
        "floor",
        "cascaded_map",
        4096);
}

/// A roof from high above everything that receives down to the floor; a table under its middle.
Stage roof_over_table(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("table", scene::make_box({1.0F, 1.5F, 1.0F}), at({5.0, 0.75, 0.0}));
    const double length = std::hypot(20.0, height);
    scene::Transform place = at({0.0, 0.3 + height * 0.5, 0.0});
    place.rotation =
        glm::angleAxis(static_cast<float>(-std::atan2(height, 20.0)), glm::vec3(0.0F, 0.0F, 1.0F));
    const ecs::Entity roof =
        builder.add("roof", scene::make_plane({static_cast<float>(length), 4.0F}), place);
    builder.world.registry.patch<scene::ShadowRole>(
        roof, [](scene::ShadowRole& role) { role.receives = false; });
    builder.add_light(sun_at(70.0));
    Stage stage = one_map(
        builder,
        camera_looking({5.0, 2.2, 5.0}, {5.0, 1.0, 0.0}, kPictureSize, kPictureSize),
        "sun",
        "table",
        "cascaded_map",
        1024);
    stage.level.shadows.receivers["floor"].technique = "cascaded_map";
    return stage;
}

/// A ring of wire round a bulb.
Stage guard_round_bulb(double radius) {
    WorldBuilder builder = floor_of(12.0F);
    builder.add(
        "guard",
        scene::make_torus(static_cast<float>(radius), static_cast<float>(radius) * 0.15F),
        at({0.0, 2.0 - 0.8 * radius, 0.0}));
    builder.add_light(lamp_at({0.0, 2.0, 0.0}));
    return one_map(
        builder,
        camera_looking({0.0, 4.5, 5.0}, {0.0, 0.0, 0.0}, kPictureSize, kPictureSize),
        "lamp",
        "floor",
        "cube_map",
        1024);
}

} // namespace

std::vector<Case> map_depth_cases() {
    return {
        {"M3",
         "an open sheet, drawn by its back, throws no shadow",
         sheet_over_floor,
         {0.5, 3.0, 1.5},
         Remedy::map_front_faces,
         {light_leak_at_most(0.0), false_shadow_at_most(0.0)}},
        {"M6",
         "eight bits cannot tell a board from the floor",
         low_board,
         {0.05, 0.5, 0.1},
         Remedy::map_fine_depth,
         {light_leak_at_most(0.0), false_shadow_at_most(0.0)}},
        {"M8",
         "a roof whose corners are moved to the near plane sinks under the table",
         roof_over_table,
         {8.0, 16.0, 12.0},
         Remedy::map_fragment_pancaking,
         {light_leak_at_most(0.0), false_shadow_at_most(0.0)}},
        {"M13",
         "the guard round a bulb throws no shadow",
         guard_round_bulb,
         {0.03, 0.12, 0.06},
         Remedy::map_near_casters,
         right_beyond_texels()},
    };
}

} // namespace atlas
