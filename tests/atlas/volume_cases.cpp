// Failures of stencil shadow volumes, whatever the caster: where the eye is, how counts go wrong,
// what rounds. Those of casters that are no clean solids are in volume_mesh_cases.cpp.
//
// Sources: C. Everitt and M. Kilgard, "Practical and Robust Stenciled Shadow Volumes for
// Hardware-Accelerated Rendering", 2002; M. McGuire, "Efficient Shadow Volume Rendering", GPU Gems,
// 2004.
//
// V13 and V15 cannot occur (impossible.cpp); V14 and V16 are refused (refusals.cpp).

#include "tests/atlas/volume_stage.hpp"
#include "tests/support/worlds.hpp"

#include <fmt/format.h>

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

/// A ball between a lamp and a camera that crosses its shadow.
Stage eye_in_shadow(double x) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(1.0F), at({0.0, 3.0, 0.0}));
    builder.add("post", scene::make_box({0.3F, 2.0F, 0.3F}), at({0.5, 1.0, -4.0}));
    builder.add_light(lamp_at({0.0, 6.0, 0.0}));
    Stage stage = served(builder, "lamp");
    stage.camera = camera_looking({x, 1.0, 0.2}, {x, 0.7, -5.0}, kPictureSize, kPictureSize);
    return stage;
}

Stage ball_under_lamp(double lamp_height) {
    WorldBuilder builder = floor_of(80.0F);
    builder.add("ball", scene::make_sphere(0.5F), at({0.0, 10.0, 0.0}));
    builder.add_light(lamp_at({0.0, lamp_height, 0.0}));
    Stage stage = served(builder, "lamp");
    stage.camera = camera_looking({0.0, 30.0, 40.0}, {0.0, 0.0, 0.0}, kPictureSize, kPictureSize);
    return stage;
}

Stage pile_of_slabs(double count) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("slab 0", scene::make_box({2.0F, 0.005F, 2.0F}), at({0.0, 1.0, 0.0}));
    for (int i = 1; i < static_cast<int>(count); ++i)
        builder.add_instance(fmt::format("slab {}", i), 1, at({0.0, 1.0 + 0.01 * i, 0.0}));
    builder.add_light(sun_along({0.0, -1.0, 0.0}));
    return served(builder, "sun");
}

/// The same as one mesh.
Stage stack_of_slabs(double count) {
    WorldBuilder builder = floor_of(20.0F);
    const scene::Mesh slab = scene::make_box({2.0F, 0.005F, 2.0F});
    scene::Mesh stack = slab;
    for (int i = 1; i < static_cast<int>(count); ++i)
        test_support::add_part(stack, slab, {0.0F, 0.01F * static_cast<float>(i), 0.0F});
    scene::finish_mesh(stack);
    builder.add("stack", std::move(stack), at({0.0, 1.0, 0.0}));
    builder.add_light(sun_along({0.0, -1.0, 0.0}));
    return served(builder, "sun");
}

/// A ring, smooth enough to be simplified, whose lit inside bends the way that proxies bulge.
Stage simplified_ring(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh ring = scene::make_torus(1.0F, 0.35F, 96, 40);
    ring.proxies = scene::make_proxies(ring);
    builder.add("ring", std::move(ring), at({0.0, 1.0, 0.0}));
    builder.add_light(sun_at(elevation, -60.0));
    Stage stage = served(builder, "sun", "ring");
    stage.camera = camera_looking({0.0, 3.5, 3.0}, {0.0, 0.8, 0.0}, kPictureSize, kPictureSize);
    stage.level.shadows.scene.proxy = 1;
    return stage;
}

/// Marbles all over the floor: each volume reaches a small part of the picture.
Stage marbles(double count) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("marble 0", scene::make_sphere(0.15F), at({-2.8, 0.15, -2.8}));
    for (int i = 1; i < static_cast<int>(count); ++i)
        builder.add_instance(
            fmt::format("marble {}", i), 1, at({0.8 * (i % 8) - 2.8, 0.15, 0.8 * (i / 8) - 2.8}));
    builder.add_light(sun_at(60.0));
    return served(builder, "sun");
}

/// Pixels of the stencil that a frame touches, for each of the picture's.
Gate stencil_fragments_a_pixel(double at_most) {
    return {
        "stencil fragments a pixel",
        [](const Observation& seen) {
            return static_cast<double>(seen.counters.stencil_fragments)
                   / (static_cast<double>(kPictureSize) * kPictureSize);
        },
        at_most};
}

Stage ball_over_floor(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(0.6F), at({0.0, 1.2, 0.0}));
    builder.add_light(sun_at(elevation));
    return served(builder, "sun");
}

/// An open ring that shades itself.
Stage ring(double elevation, const glm::dvec3& origin) {
    WorldBuilder builder(origin);
    builder.add("floor", scene::make_plane(glm::vec2(20.0F)));
    scene::Transform place = at({0.0, 1.5, 0.0});
    place.rotation = glm::angleAxis(0.6F, glm::normalize(glm::vec3(1.0F, 0.3F, 0.2F)));
    scene::Mesh mesh = scene::make_torus(1.0F, 0.35F);
    mesh.indices.resize(mesh.indices.size() - 3); // open, so that its caps are looked through
    mesh.submeshes.clear();
    scene::finish_mesh(mesh);
    builder.add("ring", std::move(mesh), place);
    builder.add_light(sun_at(elevation, 50.0));
    Stage stage = served(builder, "sun", "ring");
    stage.camera.position += origin;
    return stage;
}

/// A ring and, of the same mesh, an awning that shades the eye: the caps are needed.
Stage ring_with_awning(const scene::PlacedLight& sun) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh mesh = scene::make_torus(1.0F, 0.35F);
    const scene::CameraView camera = usual_camera(kPictureSize);
    const double middle_px = 0.5 * kPictureSize;
    const glm::dvec3 near_middle =
        camera.position
        + camera.ray_direction(middle_px, middle_px) * static_cast<double>(camera.near);
    // Smaller than the near rectangle, so that its outline cuts it.
    const glm::vec3 awning(
        near_middle - glm::dvec3(sun.direction) * 3.0 - glm::dvec3(0.0, 1.5, 0.0));
    test_support::append(mesh, scene::make_box(glm::vec3(0.06F)), awning);
    builder.add("ring", std::move(mesh), at({0.0, 1.5, 0.0}));
    builder.add_light(sun);
    return served(builder, "sun", "ring");
}

Stage lit_from_beside(double elevation) {
    return ring_with_awning(sun_at(elevation, 50.0));
}

/// What is looked at from near the light leaves the shadow far behind.
Stage lit_from_behind_the_eye(double elevation) {
    return ring_with_awning(sun_at(elevation, -90.0));
}

Stage ring_far_away(double distance) {
    return ring(50.0, {distance, 0.0, distance});
}

} // namespace

std::vector<Case> volume_cases() {
    const std::vector<Gate> exact = exact_shape();
    return {
        {.id = "V1",
         .sentence = "lit and dark swap where the eye is in a shadow",
         .build = eye_in_shadow,
         .sweep = {-4.0, 4.0, 0.0},
         .remedy = Remedy::volume_z_fail,
         .gates = exact},
        {.id = "V2",
         .sentence = "a part of the picture is inverted where the near plane cuts a volume",
         .build = eye_in_shadow,
         .sweep = {1.6, 2.0, 1.76},
         .remedy = Remedy::volume_z_fail,
         .gates = exact},
        {.id = "V3",
         .sentence = "shadows vanish where a far plane cuts their volumes open",
         .build = lit_from_behind_the_eye,
         .sweep = {30.0, 45.0, 35.0},
         .remedy = Remedy::volume_no_far_plane,
         .gates = exact},
        {.id = "V4",
         .sentence = "a volume of fixed length ends above the floor",
         .build = ball_under_lamp,
         .sweep = {10.6, 14.0, 10.6},
         .remedy = Remedy::volume_infinite,
         .gates = exact},
        {.id = "V5",
         .sentence = "the shadow of 256 slabs is lit",
         .build = pile_of_slabs,
         .sweep = {250.0, 260.0, 256.0},
         .remedy = Remedy::volume_batches,
         .gates = exact},
        {.id = "V5Stack",
         .sentence = "the shadow of 256 slabs in one mesh is lit",
         .build = stack_of_slabs,
         .sweep = {250.0, 260.0, 256.0},
         .remedy = Remedy::volume_batches,
         .gates = exact},
        {.id = "V5b",
         .sentence = "counts that stop at their limits leave light in the shadow",
         .build = ball_over_floor,
         .sweep = {20.0, 80.0, 50.0},
         .remedy = Remedy::volume_wrap,
         .gates = exact},
        {.id = "V12",
         .sentence = "the lit side of a caster is dark",
         .build = lit_from_beside,
         .sweep = {20.0, 80.0, 50.0},
         .remedy = Remedy::volume_equal_depth,
         .gates = exact},
        {.id = "V12b",
         .sentence = "corners computed in the world speckle the lit side",
         .build = ring_far_away,
         .sweep = {0.0, 10000.0, 10000.0},
         .remedy = Remedy::volume_mesh_space,
         .gates = exact},
        {.id = "V17",
         .sentence = "many small volumes fill the picture many times, rightly and slowly",
         .build = marbles,
         .sweep = {1.0, 64.0, 64.0},
         .remedy = Remedy::volume_scissor,
         .gates = {largest_error_inside(0.0), stencil_fragments_a_pixel(1.0)}},
        {.id = "Proxy",
         .sentence = "a simplified caster darkens its own surface in spots",
         .build = simplified_ring,
         .sweep = {30.0, 80.0, 50.0},
         .remedy = Remedy::volume_own_surface,
         // Edges on the floor are off by what was predicted, here and there by more than a pixel.
         .gates = {no_false_shadow_inside(), largest_error_inside(2.0)}},
    };
}

} // namespace atlas
