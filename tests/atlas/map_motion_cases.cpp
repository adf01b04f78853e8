// Failures of shadow maps that show when something moves: texels that crawl, breathe and turn.
//
// Sources: M. Valient, "Stable Rendering of Cascaded Shadow Maps", ShaderX6, 2008; A. Lauritzen et
// al., "Sample Distribution Shadow Maps", 2011 (ranges that follow every pixel).

#include "tests/atlas/map_stage.hpp"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::camera_looking;
using test_support::sun_along;
using test_support::WorldBuilder;

/// Posts on far more ground than the camera sees, under maps with texels of many pixels: a map
/// covers what is in view, and must follow.
Stage posts(float ground = 120.0F, double height = 0.6) {
    WorldBuilder builder;
    builder.add("floor", scene::make_plane(glm::vec2(ground)));
    constexpr int kReach = 5;
    for (int row = -kReach; row <= kReach; ++row)
        for (int column = -kReach; column <= kReach; ++column) {
            scene::Transform place = at({4.0 * column + 0.9 * row, height, 4.0 * row});
            place.rotation = glm::quat(glm::vec3(
                0.0F,
                glm::radians(31.0F * static_cast<float>(row) + 17.0F * static_cast<float>(column)),
                0.0F));
            const std::string name = fmt::format("post {} {}", row, column);
            if (builder.world.assets.meshes.size() == 1)
                builder.add(name, scene::make_box({0.5F, 1.2F, 0.5F}), place);
            else
                builder.add_instance(name, 1, place);
        }
    builder.add_light(sun_along({-0.6, -1.0, -0.35}));
    const scene::CameraView camera =
        camera_looking({0.4, 2.6, 6.0}, {0.0, 0.0, 0.5}, kPictureSize, kPictureSize);
    Stage stage = one_map(builder, camera, "sun", "floor", "cascaded_map", 64);
    stage.level.shadows.scene.cascades = 4;
    stage.level.shadows.scene.filter = "nearest";
    return stage;
}

void walk(Stage& stage, const scene::CameraView& start, double metres) {
    glm::dvec3 forward = -glm::dvec3(start.world_from_view[2]);
    forward.y = 0.0;
    stage.camera.position = start.position + glm::normalize(forward) * metres;
}

/// @param pace metres a frame
Stage walk_among_posts(double pace) {
    Stage stage = posts();
    stage.move = [start = stage.camera, pace](Stage& moved, int frame) {
        walk(moved, start, pace * frame);
    };
    return stage;
}

/// @param pace degrees a frame
Stage look_round(double pace) {
    Stage stage = posts();
    stage.move = [start = stage.camera, pace](Stage& moved, int frame) {
        const glm::dmat4 turn =
            glm::rotate(glm::dmat4(1.0), glm::radians(pace * frame), glm::dvec3(0.0, 1.0, 0.0));
        moved.camera.world_from_view =
            glm::mat3(glm::dmat3(turn) * glm::dmat3(start.world_from_view));
    };
    return stage;
}

void set_transform(
    Stage& stage, const std::string& name, const std::function<void(scene::Transform&)>& change) {
    scene::World& world = stage.level.world;
    world.registry.each<scene::Name>([&](ecs::Entity entity, const scene::Name& found) {
        if (found.text == name) world.registry.patch<scene::Transform>(entity, change);
    });
}

/// A sun that passes the vertical over boxes that hover. @param pace degrees a frame
Stage sun_over_the_top(double pace) {
    Stage stage = posts(120.0F, 3.0);
    stage.move = [pace](Stage& moved, int frame) {
        const double tilt = glm::radians(pace * (frame - 5.5));
        set_transform(moved, "sun", [&](scene::Transform& transform) {
            transform.rotation = scene::rotation_along(
                glm::normalize(glm::vec3(std::sin(tilt), -std::cos(tilt), 0.003)));
        });
    };
    return stage;
}

/// A bird that is near in one frame and far away in the next. @param farthest metres
Stage bird_that_comes_and_goes(double farthest) {
    Stage stage = posts(30.0F);
    scene::World& world = stage.level.world;
    const ecs::Entity bird = world.registry.create();
    world.registry.add(bird, scene::Name{"bird"});
    world.registry.add(bird, at({3.0, 4.0, 0.0}, glm::vec3(0.2F)));
    world.registry.add(bird, scene::WorldTransform{});
    world.registry.add(bird, scene::MeshInstance{1});
    world.registry.add(bird, scene::ShadowRole{.casts = false});
    stage.move = [farthest](Stage& moved, int frame) {
        set_transform(moved, "bird", [&](scene::Transform& transform) {
            transform.position.z = frame % 2 == 0 ? -farthest : 0.0;
        });
    };
    return stage;
}

/// Flips in units of those that truth has on a second grid: 1 is as still as a picture can be.
/// Edges of texels wider than a pixel are longer than the true ones, and flip in proportion.
Gate flicker_ratio(double at_most) {
    return {
        "flicker over the truth's own",
        [](const Observation& seen) {
            const measure::Figure& ratio = seen.motion->flicker_ratio;
            return ratio.known() ? ratio.value() : seen.motion->flicker_per_px.value();
        },
        at_most};
}

Gate pop_at_most(double share) {
    return {
        "sudden change of a tile, share of its light",
        [](const Observation& seen) { return seen.motion->pop.value(); },
        share};
}

} // namespace

std::vector<Case> map_motion_cases() {
    return {
        {"M19",
         "edges crawl when the camera walks",
         walk_among_posts,
         {0.005, 0.04, 0.0233},
         Remedy::map_snapped_texels,
         {flicker_ratio(5.0)}},
        {"M20",
         "texels breathe when the camera turns",
         look_round,
         {0.25, 2.0, 2.0},
         Remedy::map_constant_size,
         {flicker_ratio(3.5)}},
        {"M22",
         "the map turns by a right angle when the sun passes the vertical",
         sun_over_the_top,
         {0.02, 0.08, 0.06},
         Remedy::map_steady_up,
         {pop_at_most(0.05)}},
        {"M23",
         "a bird in the distance resizes the maps of what is near",
         bird_that_comes_and_goes,
         {30.0, 120.0, 90.0},
         Remedy::map_held_range,
         {pop_at_most(0.05)}},
    };
}

} // namespace atlas
