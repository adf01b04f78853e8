// Failures of shadows projected on planes.
//
// Sources: J. Blinn, "Me and My (Fake) Shadow", IEEE CG&A, 1988; P. Heckbert and M. Herf,
// "Simulating Soft Shadows with Graphics Hardware", CMU-CS-97-104, 1997.
//
// P4, that casters over each other must not darken twice, is no case for hard shadows: masks take
// the minimum; for soft ones it is in soft_planar_cases.cpp. P9, a sun that grazes the floor, has
// nothing to draw: below one degree planar refuses
// (tests/systems/shadows/planar_prediction_test.cpp), and above it the scissor ends at the
// receiver.

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

#include <fmt/format.h>

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

/// A camera that sees `width` metres round a target 20 degrees below it.
scene::CameraView camera_far_from(const glm::dvec3& target, double distance, double width) {
    const double down = glm::radians(20.0);
    const glm::dvec3 away(0.0, std::sin(down), std::cos(down));
    scene::CameraView camera =
        camera_looking(target + away * distance, target, kPictureSize, kPictureSize);
    camera.fov_y = static_cast<float>(2.0 * std::atan(0.5 * width / distance));
    return camera;
}

scene::Mesh cube(float side) {
    return scene::make_box(glm::vec3(side));
}

/// The receiver's name of the lowest flat patch of a mesh that faces up.
std::string lowest_top(const std::string& name, const scene::Mesh& mesh) {
    std::size_t lowest = mesh.patches.size();
    for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
        const scene::FlatPatch& patch = mesh.patches[i];
        if (patch.normal.y < 0.99F) continue;
        if (lowest == mesh.patches.size() || patch.offset < mesh.patches[lowest].offset) lowest = i;
    }
    return fmt::format("{}#{}", name, lowest + 1);
}

Stage on_floor(WorldBuilder& builder, const std::string& light) {
    return pinned_stage(
        std::move(builder.world), usual_camera(kPictureSize), light, "floor", "planar");
}

Stage cube_far_away(double distance) {
    WorldBuilder builder = floor_of(200.0F);
    builder.add("cube", cube(1.0F), at({0.0, 0.5, 0.0}));
    builder.add_light(sun_along({0.4, -1.0, 0.3}));
    return pinned_stage(
        std::move(builder.world),
        camera_far_from({0.0, 0.0, 0.5}, distance, 4.0),
        "sun",
        "floor",
        "planar");
}

Stage book_at_the_edge(double distance) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("cube", cube(1.0F), at({0.0, 0.5, 0.0}));
    builder.add("book", scene::make_box({0.3F, 0.02F, 0.4F}), at({1.1, 0.01, 0.5}));
    builder.add_light(sun_along({1.0, -1.0, 0.0}));
    return pinned_stage(
        std::move(builder.world),
        camera_far_from({1.1, 0.0, 0.5}, distance, 1.2),
        "sun",
        "floor",
        "planar");
}

Stage ball_beside_table(double x) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh table = scene::make_box({2.0F, 0.1F, 2.0F});
    const std::string receiver = lowest_top("table", table);
    builder.add("table", std::move(table), at({0.0, 0.95, 0.0}));
    builder.add("ball", scene::make_sphere(0.4F), at({x, 2.0, 0.0}));
    builder.add_light(sun_along({1.0, -1.0, 0.0}));
    return pinned_stage(
        std::move(builder.world),
        camera_looking({0.0, 4.0, 5.0}, {0.7, 0.5, 0.0}, kPictureSize, kPictureSize),
        "sun",
        receiver,
        "planar");
}

Stage cube_over_lamp(double y) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("cube", cube(0.5F), at({1.0, y, 0.0}));
    builder.add("other", cube(0.5F), at({2.5, 0.5, 0.0})); // something under the lamp
    builder.add_light(lamp_at({0.0, 2.0, 0.0}));
    return on_floor(builder, "lamp");
}

Stage pole_past_lamp(double y) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("pole", scene::make_box({0.2F, 3.0F, 0.2F}), at({1.0, y, 0.0}));
    builder.add_light(lamp_at({0.0, 2.0, 0.0}));
    return on_floor(builder, "lamp");
}

Stage ball_through_floor(double y) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(0.4F), at({0.0, y, 0.0}));
    builder.add("cube", cube(0.5F), at({2.0, 1.0, 0.0})); // something over the floor
    builder.add_light(lamp_at({0.0, 4.0, 0.0}));
    return on_floor(builder, "lamp");
}

Stage half_sunk_ball(double elevation) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("ball", scene::make_sphere(1.0F));
    builder.add_light(sun_at(elevation));
    return on_floor(builder, "sun");
}

Stage lamp_through_floor(double y) {
    WorldBuilder builder = floor_of(6.0F);
    builder.add("wall", scene::make_box({20.0F, 20.0F, 0.1F}), at({0.0, 0.0, -4.0}));
    builder.add("ball", scene::make_sphere(0.4F), at({0.0, 1.5, 0.0}));
    builder.add_light(lamp_at({0.0, y, 0.0}));
    Stage stage = on_floor(builder, "lamp");
    stage.level.shadows.scene.technique = "none"; // what is turned away stays as planar left it
    return stage;
}

Stage two_lights(double lamp_x) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("cube", cube(1.0F), at({0.0, 0.5, 0.0}));
    builder.add_light(lamp_at({lamp_x, 4.0, 2.0}));
    builder.add_light(sun_along({1.0, -1.0, 0.0}));
    return on_floor(builder, "sun");
}

/// A seat with a back, as one mesh.
Stage chair(double turn_deg) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh seat = scene::make_box({2.0F, 0.2F, 2.0F});
    scene::Mesh back = scene::make_box({2.0F, 1.5F, 0.2F});
    test_support::append(seat, back, {0.0F, 0.85F, -0.9F});
    const std::string receiver = lowest_top("chair", seat);
    builder.add("chair", std::move(seat), at({0.0, 0.9, 0.0}));
    const double turn = glm::radians(turn_deg);
    builder.add_light(sun_along({std::sin(turn), -1.0, std::cos(turn)}));
    return pinned_stage(
        std::move(builder.world),
        camera_looking({0.0, 3.5, 4.0}, {0.0, 0.8, 0.0}, kPictureSize, kPictureSize),
        "sun",
        receiver,
        "planar");
}

/// A sheet with holes over the floor.
Stage lattice(double height) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Texture holes;
    holes.image = engine::Image(4, 4, 4);
    for (std::size_t i = 0; i < holes.image.bytes.size(); ++i)
        holes.image.bytes[i] = (i / 4 + i / 16) % 2 == 0 ? 255 : 0;
    builder.world.assets.textures.push_back(std::move(holes));
    scene::Material material;
    material.texture = 0;
    material.alpha_masked = true;
    material.double_sided = true;
    builder.world.assets.materials.push_back(material);
    scene::Mesh sheet = scene::make_plane({3.0F, 3.0F});
    sheet.submeshes[0].material = 1;
    builder.add("sheet", std::move(sheet), at({0.0, height, 0.0}));
    builder.add_light(sun_along({0.6, -1.0, 0.4}));
    return on_floor(builder, "sun");
}

/// A slab in the shadow of a ball.
Stage slab_on_floor(double height) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh slab = scene::make_box({3.0F, static_cast<float>(height), 3.0F});
    const std::string top = lowest_top("slab", slab);
    builder.add("slab", std::move(slab), at({0.8, 0.5 * height, 0.0}));
    builder.add("ball", scene::make_sphere(0.8F), at({-3.5, 2.5, 0.0}));
    builder.add_light(sun_at(30.0));
    Stage stage = on_floor(builder, "sun");
    stage.level.shadows.receivers[top].technique = "planar";
    return stage;
}

Gate no_dark_behind_light() {
    return {"mask lowered where no light falls, px", [](const Observation& seen) {
                const measure::Comparison& comparison = seen.comparison;
                double count = 0.0;
                for (std::size_t i = 0; i < comparison.kind.size(); ++i)
                    if (comparison.kind[i] == measure::PixelKind::facing_away
                        && comparison.measured.visibility[i] < 1.0F)
                        count += 1.0;
                return count;
            }};
}

} // namespace

std::vector<Case> planar_cases() {
    const std::vector<Gate> exact = exact_shape();
    return {
        {"P1",
         "the shadow fights with its receiver's depth",
         cube_far_away,
         {5.0, 200.0, 60.0},
         Remedy::planar_stencil,
         exact},
        {"P2",
         "an offset paints the floor's shadow over a book that lies on it",
         book_at_the_edge,
         {60.0, 200.0, 150.0},
         Remedy::planar_no_offset,
         exact},
        {"P3",
         "the table's shadow hangs in the air beside it",
         ball_beside_table,
         {0.0, 1.5, 0.9},
         Remedy::planar_stencil,
         exact},
        {"P5",
         "a cube above the lamp throws a mirrored shadow",
         cube_over_lamp,
         {1.0, 3.5, 3.0},
         Remedy::planar_anti_shadow_clip,
         exact},
        {"P6",
         "a pole past the lamp throws a wedge that flips through infinity",
         pole_past_lamp,
         {1.5, 2.5, 2.0},
         Remedy::planar_anti_shadow_clip,
         exact},
        {"P7",
         "a ball under the floor throws a shadow on it",
         ball_through_floor,
         {-2.0, 2.0, -1.0},
         Remedy::planar_behind_clip,
         exact},
        {"P8",
         "the lower half of a sunken ball throws a lobe toward the sun",
         half_sunk_ball,
         {15.0, 75.0, 15.0},
         Remedy::planar_behind_clip,
         exact},
        {"P10",
         "a lamp under the floor darkens it",
         lamp_through_floor,
         {1.0, -1.0, -0.5},
         std::nullopt,
         {no_dark_behind_light()}},
        {"P11",
         "a shadow does not climb the slab that lies in it",
         slab_on_floor,
         {0.05, 0.5, 0.5},
         Remedy::planar_own_plane,
         exact},
        {"P12",
         "the second light's shadow has holes where the first one's lies",
         two_lights,
         {-3.0, 3.0, -1.5},
         Remedy::planar_fresh_stencil,
         exact},
        {"Lattice",
         "a sheet with holes throws a whole shadow",
         lattice,
         {0.5, 3.0, 1.0},
         std::nullopt,
         // Where four cells meet, a pixel may be joined to either two.
         {largest_error_inside(1.0), wrong_over_precision_floor(1.0)}},
        {"Chair",
         "the back of a chair throws no shadow on its own seat",
         chair,
         {-60.0, 60.0, 0.0},
         std::nullopt,
         exact},
    };
}

} // namespace atlas
