// What techniques refuse, and the words in which they do.

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

namespace atlas {

namespace {

using test_support::at;
using test_support::floor_of;
using test_support::sun_at;
using test_support::usual_camera;
using test_support::WorldBuilder;

Stage pinned(
    WorldBuilder& builder,
    const std::string& light,
    const std::string& receiver,
    const std::string& technique) {
    return pinned_stage(
        std::move(builder.world), usual_camera(kPictureSize), light, receiver, technique);
}

/// A ball on a floor under a light. @param on what the technique is pinned to
Stage ball_under(
    const scene::PlacedLight& light, const std::string& on, const std::string& technique) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(0.5F), at({0.0, 1.2, 0.0}));
    builder.add_light(light);
    return pinned(builder, light.name, on, technique);
}

Stage grazing_sun() {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("post", scene::make_box({0.3F, 2.0F, 0.3F}), at({-3.0, 1.0, 0.0}));
    builder.add_light(sun_at(0.5));
    return pinned(builder, "sun", "floor", "planar");
}

/// A boulder in the shadow of a wall: nothing on it is flat.
Stage uneven_receiver() {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("wall", scene::make_box({0.1F, 2.0F, 3.0F}), at({-1.5, 1.0, 0.0}));
    builder.add("boulder", scene::make_sphere(0.8F), at({0.0, 0.4, 0.0}));
    builder.add_light(sun_at(40.0));
    return pinned(builder, "sun", "boulder", "planar");
}

Stage lamp_amid_casters() {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("cage", scene::make_torus(0.6F, 0.1F), at({0.0, 1.5, 0.0}));
    builder.add_light(lamp_at({0.0, 1.5, 0.0}));
    return pinned(builder, "lamp", "floor", "shadow_texture");
}

Stage lamp_close_to_caster() {
    return ball_under(lamp_at({0.0, 1.75, 0.0}), "floor", "shadow_texture");
}

Stage leaf_card() {
    WorldBuilder builder = floor_of(20.0F);
    add_leaf_material(builder);
    scene::Mesh card = scene::make_plane(glm::vec2(2.0F));
    card.submeshes[0].material = 1;
    builder.add("leaf", std::move(card), at({0.0, 1.5, 0.0}));
    builder.add_light(sun_at(50.0));
    return pinned(builder, "sun", "floor", "volume");
}

Stage driver_that_clamps() {
    Stage stage = ball_under(sun_at(50.0), "floor", "volume");
    stage.wraps_stencil = false;
    return stage;
}

Stage lamp_in_blob() {
    return ball_under(lamp_at({0.0, 1.75, 0.0}), "floor", "blob");
}

Stage wide_spot() {
    scene::PlacedLight spot = lamp_at({0.0, 4.0, 0.0});
    spot.light.kind = scene::LightKind::spot;
    spot.light.inner_angle = spot.light.outer_angle = glm::radians(75.0F);
    spot.direction = {0.0F, -1.0F, 0.0F};
    return ball_under(spot, "floor", "spot_map");
}

Stage lamp_for_cascades() {
    return ball_under(lamp_at({0.0, 4.0, 0.0}), "floor", "cascaded_map");
}

Stage sun_for_cube() {
    return ball_under(sun_at(50.0), "floor", "cube_map");
}

} // namespace

std::vector<Refusal> refusals() {
    return {
        {"P9",
         "under a sun at the horizon a shadow grows beyond all numbers",
         "planar",
         grazing_sun,
         "the light grazes the receiver"},
        {"P11",
         "on an uneven receiver a shadow does not climb",
         "planar",
         uneven_receiver,
         "the receiver is not flat"},
        {"T10",
         "no picture holds casters on all sides of a lamp",
         "shadow_texture",
         lamp_amid_casters,
         "the lamp is amid the casters"},
        {"T11",
         "texels of a wide projection are spent on its rim",
         "shadow_texture",
         lamp_close_to_caster,
         "seen from the lamp the casters reach"},
        {"V16",
         "a stencil volume of a leaf is that of its card",
         "volume",
         leaf_card,
         "'leaf' has holes that its texture cuts"},
        {"V14",
         "counts of volumes are wrong on a driver that clamps them",
         "volume",
         driver_that_clamps,
         "this driver's stencil does not wrap"},
        {"B5",
         "no ellipse has the outline of a caster that surrounds the lamp",
         "blob",
         lamp_in_blob,
         "the lamp is as near to 'ball' as that is large"},
        {"M10",
         "a wide spot has few texels in its middle",
         "spot_map",
         wide_spot,
         "the cone opens 75 degrees to each side"},
        {"M27",
         "parallel rays cannot hold a lamp's shadows",
         "cascaded_map",
         lamp_for_cascades,
         "it serves directional lights"},
        {"M28",
         "a cube of maps has no place for the sun",
         "cube_map",
         sun_for_cube,
         "it serves point and spot lights"},
    };
}

} // namespace atlas
