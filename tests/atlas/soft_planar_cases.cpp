// Failures of soft shadows on planes: sums of projections from points of the light.
//
// Sources: P. Heckbert and M. Herf, "Simulating Soft Shadows with Graphics Hardware",
// CMU-CS-97-104, 1997; E. Haines, "Soft Planar Shadows Using Plateaus", JGT, 2001.

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

#include <algorithm>
#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::camera_looking;
using test_support::floor_of;
using test_support::usual_camera;
using test_support::WorldBuilder;

constexpr float kLampRadius = 0.25F;

scene::PlacedLight ball_lamp(const glm::dvec3& position, float radius) {
    scene::PlacedLight lamp = lamp_at(position);
    lamp.light.radius = radius;
    return lamp;
}

/// A floor that planar shadows serve within a budget.
Stage on_floor(
    WorldBuilder& builder, const scene::CameraView& camera, float budget_px, int samples = 0) {
    Stage stage = pinned_stage(std::move(builder.world), camera, "lamp", "floor", "planar");
    stage.level.shadows.scene.error_px = budget_px;
    if (samples > 0) stage.level.shadows.scene.samples = samples;
    return stage;
}

/// A card over the floor, its penumbra near the camera.
WorldBuilder card_at(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("card", scene::make_box({2.0F, 0.02F, 2.0F}), at({0.0, height, 0.0}));
    builder.add_light(ball_lamp({0.0, 4.0, 0.0}, kLampRadius));
    return builder;
}

scene::CameraView camera_at_the_edge() {
    return camera_looking({1.5, 2.2, 3.2}, {1.2, 0.0, 0.9}, kPictureSize, kPictureSize);
}

Stage card(double height) {
    WorldBuilder builder = card_at(height);
    return on_floor(builder, camera_at_the_edge(), 0.25F);
}

Stage card_of_a_hundred(double height) {
    WorldBuilder builder = card_at(height);
    return on_floor(builder, camera_at_the_edge(), 0.25F, 100);
}

/// Two plates, one over the other.
Stage pile(double gap) {
    WorldBuilder builder = floor_of(20.0F);
    const glm::vec3 size(1.0F, 0.02F, 1.0F);
    builder.add("lower", scene::make_box(size), at({0.0, 1.2, 0.0}));
    builder.add("upper", scene::make_box(size), at({0.0, 1.2 + gap, 0.0}));
    builder.add_light(ball_lamp({0.0, 5.0, 0.5}, 0.4F));
    return on_floor(
        builder,
        camera_looking({0.0, 3.0, 4.5}, {0.0, 0.0, 0.0}, kPictureSize, kPictureSize),
        0.25F);
}

/// A ball under a lamp that is larger than it: nothing lies in its umbra.
Stage small_ball(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(0.25F), at({0.0, height, 0.0}));
    builder.add_light(ball_lamp({0.0, 4.0, 0.0}, 0.5F));
    Stage stage = on_floor(builder, usual_camera(kPictureSize), 0.25F);
    stage.level.shadows.scene.way = "plateau";
    return stage;
}

/// An outline of many corners, as a plateau whatever it is worth.
Stage round_plateau(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(0.8F), at({0.0, height, 0.0}));
    builder.add_light(ball_lamp({0.0, 6.0, 0.0}, kLampRadius));
    Stage stage = on_floor(builder, usual_camera(kPictureSize), 100.0F);
    stage.level.shadows.scene.way = "plateau";
    return stage;
}

/// A ball that a box may stand for.
Stage ball_from_afar(double distance) {
    WorldBuilder builder = floor_of(200.0F);
    builder.add("ball", scene::make_sphere(0.5F), at({0.0, 1.0, 0.0}));
    builder.add_light(lamp_at({1.0, 6.0, 0.0}));
    return on_floor(
        builder,
        camera_looking(
            {0.0, 0.5 * distance, 0.9 * distance}, {0.0, 0.3, 0.0}, kPictureSize, kPictureSize),
        1.0F);
}

Stage kept_card(double height) {
    Stage stage = card(height);
    stage.level.shadows.scene.way = "texture";
    return stage;
}

/// A lamp whose lower part is under the floor, or which stands on it: penumbrae are wider than
/// shadows are long.
Stage sunken_lamp(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("post", scene::make_box({0.3F, 0.5F, 0.3F}), at({0.0, 0.25, -1.0}));
    builder.add_light(ball_lamp({0.0, height, -3.0}, 0.5F));
    return on_floor(builder, usual_camera(kPictureSize), 0.5F);
}

/// Error of visibility per length of edge.
Gate width_of_error(double at_most_px) {
    return {
        "error per edge, px",
        [](const Observation& seen) {
            const measure::Figure& eps = seen.figures.eps_px;
            return eps.known() ? eps.value() : 0.0; // no edge to speak of
        },
        at_most_px};
}

Gate false_shadow(double at_most_px) {
    return {
        "dark for lit, px",
        [](const Observation& seen) { return seen.figures.false_shadow_px; },
        at_most_px};
}

Gate bias_in_penumbra(double at_most) {
    return {
        "too bright or too dark, mean over the penumbra",
        [](const Observation& seen) {
            const measure::Figure& bias = seen.figures.bias_px;
            return bias.known() ? std::abs(bias.value()) * seen.figures.edge_px
                                      / std::max(seen.figures.penumbra_px, 1.0)
                                : 1.0;
        },
        at_most};
}

} // namespace

std::vector<Case> soft_planar_cases() {
    return {
        {"P4",
         "plates over each other darken a penumbra twice",
         pile,
         {0.1, 1.0, 0.2},
         Remedy::planar_once_per_sample,
         {width_of_error(0.25), largest_error_inside(4.0)}},
        {"A1",
         "four samples make bands of a penumbra",
         card,
         {0.5, 1.5, 1.5},
         Remedy::planar_enough_samples,
         {width_of_error(0.25)}},
        {"A2",
         "a hundred samples in bytes: the umbra begins too soon",
         card_of_a_hundred,
         {0.5, 1.5, 1.5},
         Remedy::planar_float_sum,
         {width_of_error(0.25)}},
        {"A3",
         "a plateau has a black core where a large lamp leaves no umbra",
         small_ball,
         {1.0, 2.5, 2.5},
         Remedy::planar_plateau_budget,
         {width_of_error(0.6)}},
        {"A4",
         "skirts of plateaus add up where they overlap",
         round_plateau,
         {1.0, 2.0, 2.0},
         Remedy::planar_plateau_darkest,
         {false_shadow(195.0)}},
        {"Box",
         "a box throws the shadow of a ball",
         ball_from_afar,
         {3.0, 60.0, 6.0},
         Remedy::planar_box_budget,
         {width_of_error(1.0)}},
        {"Kept",
         "a shadow that is kept in a texture of the floor",
         kept_card,
         {0.5, 1.5, 1.5},
         std::nullopt,
         {width_of_error(0.3)}},
        {"A8",
         "a lamp half under the floor brightens its shadows from below",
         sunken_lamp,
         {0.1, 0.9, 0.2},
         Remedy::planar_light_horizon,
         {bias_in_penumbra(0.01)}},
    };
}

} // namespace atlas
