#include "systems/shadows/blob_prediction.hpp"

#include "systems/shadows/blob_fit.hpp"
#include "systems/shadows/screen_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadows {

namespace {

/// The part of a shadow that is drawn wrong, relative to its area: a box seen along an axis fills
/// 4 / pi of its ellipse, which leaves 1 - pi / 4; a figure with gaps, or a box seen over a corner,
/// twice as much.
constexpr double kShapeError = 0.43;

/// How much larger than its caster a shadow gets on the way to the far end of its bounds.
double
magnification(const LightView& light, const CasterGroup& casters, const engine::WorldAabb& shadow) {
    if (light.light.kind == scene::LightKind::directional) return 1.0;
    const glm::dvec3 farthest =
        glm::max(glm::abs(shadow.min - light.position), glm::abs(shadow.max - light.position));
    const double near = glm::length(casters.bounds.centre() - light.position);
    return std::max(1.0, glm::length(farthest) / std::max(near, casters.largest_radius));
}

/// Pixels of the rectangles that are drawn, one per caster.
double drawn_px(const PairView& pair, const CasterGroup& casters) {
    double sum = 0.0;
    for (const std::uint32_t index : casters.casters) {
        const engine::WorldAabb shadow =
            swept_bounds(pair.light, pair.scene.casters[index].bounds, pair.receiver.bounds);
        sum += screen_bounds(pair.scene.camera, shadow).area();
    }
    return sum;
}

/// The lamp is in the ball round the caster, from where no ellipse has the caster's outline.
bool too_near(const CasterView& caster, const LightView& light) {
    if (light.light.kind == scene::LightKind::directional) return false;
    const double distance = glm::length(caster.bounds.centre() - light.position);
    return distance <= 0.5 * glm::length(caster.bounds.extent());
}

} // namespace

engine::Result<Prediction> predict_blob(const PairView& pair, const CasterGroup& casters) {
    for (const std::uint32_t index : casters.casters)
        if (too_near(pair.scene.casters[index], pair.light))
            return engine::Error{fmt::format(
                "the lamp is as near to '{}' as that is large", pair.scene.casters[index].name)};
    Prediction prediction;
    const engine::WorldAabb shadow = swept_bounds(pair.light, casters.bounds, pair.receiver.bounds);
    if (shadow.empty()) return prediction;
    const scene::CameraView& camera = pair.scene.camera;
    const double radius_px = casters.largest_radius * magnification(pair.light, casters, shadow)
                             / pixel_size_at(camera, shadow);
    const double seen_px = screen_bounds(camera, shadow).area();
    const double area_px = std::min(std::numbers::pi * radius_px * radius_px, seen_px);
    // An error of a share of the area, spread over the edge: pi r^2 S / (2 pi r). A soft edge that
    // is 2 k r wide adds a fourth of its width: k r / 2.
    const double edge_px = 0.5 * (kShapeError + kBlobEdge) * std::sqrt(area_px / std::numbers::pi);
    const double count = static_cast<double>(casters.casters.size());
    prediction.error_px = edge_px;
    prediction.error_area_px = count * (kShapeError + kBlobEdge) * area_px;
    prediction.cost.vertices = 4.0 * count;
    prediction.cost.colour_fragments = drawn_px(pair, casters);
    prediction.cost.taps = 2.0 * prediction.cost.colour_fragments;
    prediction.cost.draws = 1.0;
    return prediction;
}

} // namespace shadows
