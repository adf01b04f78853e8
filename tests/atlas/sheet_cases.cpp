// Casters that have no inside: leaves cut out by a texture, single sheets, bars thinner than
// texels. Each in every technique that can hold it; what stencil volumes refuse is in refusals.cpp.

#include "tests/atlas/cases.hpp"
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

Stage on_floor(WorldBuilder& builder, const std::string& technique, int map_size) {
    return one_map(builder, usual_camera(kPictureSize), "sun", "floor", technique, map_size);
}

/// A card on which a round leaf is painted. @param elevation of the sun, degrees
Stage leaf(double elevation, const std::string& technique) {
    WorldBuilder builder = floor_of(20.0F);
    add_leaf_material(builder);
    scene::Mesh card = scene::make_plane(glm::vec2(3.0F));
    card.submeshes[0].material = 1;
    builder.add("leaf", std::move(card), at({0.0, 1.5, 0.0}));
    builder.add_light(sun_at(elevation, 40.0));
    return on_floor(builder, technique, 1024);
}

/// A sheet that turns over: the sun sees one side of it, then its edge, then the other.
Stage turning_sheet(double turn_deg, const std::string& technique) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Transform place = at({0.0, 1.6, 0.0});
    place.rotation =
        glm::angleAxis(static_cast<float>(glm::radians(turn_deg)), glm::vec3(1.0F, 0.0F, 0.0F));
    builder.add("sheet", scene::make_plane(glm::vec2(2.0F)), place);
    builder.add_light(sun_at(60.0, 15.0));
    return on_floor(builder, technique, 1024);
}

/// Bars a pixel wide and less. @param side of a bar, metres
Stage thin_bars(double side, const std::string& technique) {
    WorldBuilder builder = floor_of(20.0F);
    const auto width = static_cast<float>(side);
    builder.add("bar", scene::make_box({width, 1.0F, width}), at({-1.5, 0.6, 0.0}));
    for (int i = 1; i < 12; ++i)
        builder.add_instance("bar" + std::to_string(i), 1, at({-1.5 + 0.25 * i, 0.6, 0.0}));
    builder.add_light(sun_at(40.0, 75.0));
    return pinned_stage(
        std::move(builder.world),
        camera_looking({0.0, 2.2, 3.4}, {0.2, 0.0, 0.6}, kPictureSize, kPictureSize),
        "sun",
        "floor",
        technique);
}

/// A case for a technique. @param remedy of the technique
Case in_technique(
    Case one,
    const std::string& technique,
    Stage (*build)(double, const std::string&),
    std::optional<Remedy> remedy) {
    one.id += "_" + technique;
    one.build = [build, technique](double step) { return build(step, technique); };
    one.remedy = remedy;
    return one;
}

} // namespace

void add_leaf_material(WorldBuilder& builder) {
    constexpr int kSize = 64;
    scene::Texture leaf;
    leaf.image = engine::Image(kSize, kSize, 4);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double from_middle = std::hypot(x + 0.5 - kSize / 2, y + 0.5 - kSize / 2);
            std::fill_n(leaf.image.at(x, y), 3, std::uint8_t{255});
            leaf.image.at(x, y)[3] = from_middle < 0.45 * kSize ? 255 : 0;
        }
    builder.world.assets.textures.push_back(std::move(leaf));
    scene::Material material;
    material.texture = 0;
    material.alpha_masked = true;
    material.double_sided = true;
    builder.world.assets.materials.push_back(material);
}

std::vector<Case> sheet_cases() {
    const std::vector<Gate> clean = {no_false_shadow_inside(), no_light_leak_inside()};
    const Case leaves{
        "V16", "a leaf throws the shadow of its card", {}, {30.0, 80.0, 60.0}, {}, clean};
    const Case sheets{
        "Sheet", "one side of a sheet throws no shadow", {}, {0.0, 180.0, 20.0}, {}, clean};
    const Case bars{
        "Bars",
        "bars as thin as a pixel throw no shadow",
        {},
        {0.005, 0.04, 0.02},
        {},
        exact_shape()};
    Case backs = sheets; // the side that a volume is turned away from
    backs.sweep.worst = 160.0;
    return {
        in_technique(leaves, "cascaded_map", leaf, Remedy::caster_holes),
        in_technique(leaves, "shadow_texture", leaf, Remedy::caster_holes),
        in_technique(leaves, "planar", leaf, std::nullopt),
        in_technique(sheets, "cascaded_map", turning_sheet, Remedy::map_front_faces),
        in_technique(sheets, "shadow_texture", turning_sheet, std::nullopt),
        in_technique(sheets, "planar", turning_sheet, std::nullopt),
        in_technique(backs, "volume", turning_sheet, Remedy::volume_signed_edges),
        in_technique(bars, "planar", thin_bars, std::nullopt),
        in_technique(bars, "volume", thin_bars, std::nullopt),
    };
}

} // namespace atlas
