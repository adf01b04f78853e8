#include "systems/shadows/planar_prediction.hpp"

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/planar_projection.hpp"
#include "systems/shadows/screen_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadows {

namespace {

/// What rasterisers and tracers disagree by, px of every edge: a shift of 1/16 px in a random
/// direction, (2 / pi) / 16.
constexpr double kPrecisionFloorPx = 0.04;
/// Below this a sun's shadows are 57 times as long as their casters are high, and shading fades.
constexpr double kLeastSunSine = 0.0174524; // 1 degree
/// Draws of a receiver besides its casters: its mark, the wipe.
constexpr double kOwnDraws = 2.0;

/// The width of a penumbra on the plane, cast from a height above it.
/// @param sine of the light's elevation. Source: similar triangles, w = 2 R b / a over the sine,
/// with b from the caster to the plane and a from the light to the caster.
double penumbra_width(
    const LightView& light, const engine::WorldAabb& caster, double height, double sine) {
    const double b = height / sine;
    if (light.light.kind == scene::LightKind::directional)
        return 2.0 * std::tan(static_cast<double>(light.light.angular_radius)) * b / sine;
    const glm::dvec3 nearest = glm::clamp(light.position, caster.min, caster.max);
    const double radius = static_cast<double>(light.light.radius);
    return 2.0 * radius * b / std::max(glm::length(light.position - nearest), radius) / sine;
}

double highest_corner(const LitPlane& plane, const engine::WorldAabb& box) {
    double highest = 0.0;
    for (int i = 0; i < 8; ++i)
        highest = std::max(highest, plane.height(box.corner(i)));
    return std::min(highest, plane.most_height());
}

} // namespace

engine::Result<Prediction> predict_planar(const PairView& pair, const CasterGroup& casters) {
    if (!pair.receiver.flat) return engine::Error{"the receiver is not flat"};
    const scene::CameraView& camera = pair.scene.camera;
    const auto plane = lit_plane(pair.light, pair.receiver, camera.position);
    if (!plane) return Prediction{}; // no light falls on it, nothing is drawn
    const double sine = sine_of_elevation(pair.light, *plane, pair.receiver.bounds.centre());
    if (pair.light.light.kind == scene::LightKind::directional && sine < kLeastSunSine)
        return engine::Error{fmt::format(
            "the light grazes the receiver at {:.2g} degrees, expected 1 or more",
            std::asin(sine) * 180.0 / std::numbers::pi)};
    const engine::WorldAabb shadow =
        shadow_bounds(pair.light, *plane, pair.receiver, casters.bounds);
    if (shadow.empty()) return Prediction{};
    const double at_shadow =
        std::max(sine_of_elevation(pair.light, *plane, shadow.centre()), kLeastSunSine);
    const double cotangent = std::sqrt(1.0 - std::min(1.0, at_shadow * at_shadow)) / at_shadow;
    const double width = penumbra_width(
        pair.light, casters.bounds, highest_corner(*plane, casters.bounds), at_shadow);
    const ShadowFootprint footprint = shadow_footprint(pair, casters);
    Prediction prediction;
    prediction.error_px =
        kPrecisionFloorPx
        + (pair.receiver.residual * cotangent + 0.25 * width) / pixel_size_at(camera, shadow);
    prediction.error_area_px = prediction.error_px * footprint.length_px;
    const double touched = screen_bounds(camera, shadow).area();
    prediction.cost.vertices = static_cast<double>(casters.triangles);
    prediction.cost.stencil_fragments = 2.0 * touched;
    prediction.cost.colour_fragments = std::min(footprint.area_px, touched);
    prediction.cost.draws = kOwnDraws + static_cast<double>(casters.casters.size());
    return prediction;
}

} // namespace shadows
