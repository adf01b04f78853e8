// Failures of soft shadow maps and soft shadow textures.
//
// Sources: R. Fernando, "Percentage-Closer Soft Shadows", SIGGRAPH 2005; G. Guennebaud et al.,
// "Real-Time Soft Shadow Mapping by Backprojection", 2006 (two blockers).

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::camera_looking;
using test_support::floor_of;
using test_support::usual_camera;
using test_support::WorldBuilder;

constexpr int kTaps = 32;

Stage soft_map(
    WorldBuilder& builder,
    const scene::CameraView& camera,
    const std::string& light,
    const std::string& technique) {
    Stage stage = pinned_stage(std::move(builder.world), camera, light, "floor", technique);
    stage.level.shadows.scene.map_size = 1024;
    stage.level.shadows.scene.filter = "pcss";
    stage.level.shadows.scene.samples = kTaps;
    return stage;
}

scene::PlacedLight wide_sun(double elevation, double angular_radius) {
    scene::PlacedLight sun = test_support::sun_at(elevation, 25.0);
    sun.light.angular_radius = static_cast<float>(glm::radians(angular_radius));
    return sun;
}

/// A strip near the lamp across a strip near the floor: a penumbra of two metres crosses one of
/// five centimetres.
Stage crossing_strips(double shift) {
    WorldBuilder builder = floor_of(14.0F);
    builder.add("high", scene::make_box({0.6F, 0.02F, 2.0F}), at({0.0, 8.0, 0.0}));
    builder.add("low", scene::make_box({6.0F, 0.02F, 1.5F}), at({1.5, 1.0, shift}));
    scene::PlacedLight lamp = test_support::lamp_light("lamp", {0.0, 10.0, 0.0}, 500.0F, 40.0F);
    lamp.light.radius = 0.25F;
    builder.add_light(lamp);
    return soft_map(
        builder,
        camera_looking({0.0, 7.0, 5.5}, {0.0, 0.0, 0.0}, kPictureSize, kPictureSize),
        "lamp",
        "cube_map");
}

Stage card_at(double height, double angular_radius) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("card", scene::make_box({2.0F, 0.02F, 2.0F}), at({-height * 0.5, height, 0.0}));
    builder.add_light(wide_sun(60.0, angular_radius));
    return soft_map(builder, usual_camera(kPictureSize), "sun", "cascaded_map");
}

/// A card that rises, until its penumbra is half as wide as itself.
Stage rising_card(double height) {
    return card_at(height, 4.0);
}

/// A pole: its penumbra grows from nothing at its foot.
Stage standing_pole(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add(
        "pole",
        scene::make_box({0.3F, static_cast<float>(height), 0.3F}),
        at({-2.5, height * 0.5, 0.0}));
    builder.add_light(wide_sun(40.0, 2.5));
    return soft_map(builder, usual_camera(kPictureSize), "sun", "cascaded_map");
}

/// A card under a lamp, its shadow from as many points as the maps have taps.
Stage card_under_lamp(double height) {
    WorldBuilder builder = floor_of(14.0F);
    builder.add("card", scene::make_box({1.5F, 0.02F, 1.5F}), at({0.3, height, 0.0}));
    scene::PlacedLight lamp = lamp_at({-1.0, 5.0, 0.5});
    lamp.light.radius = 0.3F;
    builder.add_light(lamp);
    Stage stage = pinned_stage(
        std::move(builder.world), usual_camera(kPictureSize), "lamp", "floor", "shadow_texture");
    stage.level.shadows.scene.samples = kTaps;
    stage.level.shadows.scene.map_size = 256; // so fine that the number of points decides
    return stage;
}

/// Two cards under a lamp, side by side: where both shadows are, each hides the half that the other
/// leaves.
Stage two_halves(double gap) {
    WorldBuilder builder = floor_of(14.0F);
    for (const double side : {-1.0, 1.0})
        builder.add(
            side < 0.0 ? "left" : "right",
            scene::make_box({1.5F, 0.02F, 1.5F}),
            at({side * 0.5 * (1.5 + gap), side < 0.0 ? 2.0 : 1.9, 0.0}));
    ecs::Registry& registry = builder.world.registry;
    for (const ecs::Entity entity : registry.view<scene::Name, scene::ShadowRole>())
        if (registry.get<scene::Name>(entity).text != "floor") // groups of their own
            registry.patch<scene::ShadowRole>(
                entity, [](scene::ShadowRole& role) { role.hero = true; });
    scene::PlacedLight lamp = lamp_at({0.0, 4.0, 0.0});
    lamp.light.radius = 0.5F;
    builder.add_light(lamp);
    Stage stage = pinned_stage(
        std::move(builder.world), usual_camera(kPictureSize), "lamp", "floor", "shadow_texture");
    stage.level.shadows.scene.samples = kTaps;
    stage.level.shadows.scene.map_size = 256;
    return stage;
}

/// A card that does not receive, so that the map's near end may lie below it.
Stage high_card(double height) {
    Stage stage = card_at(height, 2.0);
    ecs::Registry& registry = stage.level.world.registry;
    for (const ecs::Entity entity : registry.view<scene::Name, scene::ShadowRole>())
        if (registry.get<scene::Name>(entity).text == "card")
            registry.patch<scene::ShadowRole>(
                entity, [](scene::ShadowRole& role) { role.receives = false; });
    return stage;
}

/// Against what as many samples of the light cost when they are spread well: 0.35 N^-0.75 of each
/// penumbra's width.
Gate error_over_samples(double at_most) {
    return {
        "error over that of as many samples",
        [](const Observation& seen) {
            const double samples = 0.35 * std::pow(kTaps, -0.75) * seen.figures.penumbra_px;
            return seen.figures.error_px / samples;
        },
        at_most};
}

} // namespace

std::vector<Case> soft_cases() {
    return {
        {"A5",
         "two blockers at different heights have one penumbra",
         crossing_strips,
         {-0.5, 0.5, 0.0},
         Remedy::soft_clusters,
         {error_over_samples(1.5)}},
        {"A6",
         "a wide penumbra is cut off",
         rising_card,
         {1.0, 6.0, 5.0},
         Remedy::soft_scaled_search,
         {error_over_samples(1.5)}},
        {"A7",
         "a penumbra has one width from the foot of a pole to its tip",
         standing_pole,
         {1.0, 5.0, 4.0},
         Remedy::soft_width,
         {error_over_samples(1.5)}},
        {"A7high",
         "a caster above all that receives seems to be low",
         high_card,
         {8.0, 16.0, 14.0},
         Remedy::soft_true_heights,
         {error_over_samples(1.5)}},
        {"Y11",
         "two cards that hide a half of a lamp each leave it half lit",
         two_halves,
         {0.0, 0.4, 0.0},
         Remedy::texture_union,
         {error_over_samples(1.5)}},
        {"Points",
         "a lamp with a size throws hard shadows",
         card_under_lamp,
         {0.5, 2.5, 2.0},
         Remedy::texture_light_points,
         {error_over_samples(1.5)}},
    };
}

} // namespace atlas
