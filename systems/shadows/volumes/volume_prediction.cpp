#include "systems/shadows/volumes/volume_prediction.hpp"

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/maps/map_error.hpp"
#include "systems/shadows/volumes/near_clip.hpp"
#include "systems/shadows/volumes/swept_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// What rasterisers and tracers disagree by, px of every edge: a shift of 1/16 px in a random
/// direction, (2 / pi) / 16.
constexpr double kPrecisionFloorPx = 0.04;
/// A facing test on the processor, in vertices of a draw: 15 ns against 40 ns.
constexpr double kVerticesPerFacing = 0.4;

/// Triangles to draw for one caster, and its facing tests.
double vertices_of(const PairView& pair, const CasterView& caster) {
    const auto triangles = static_cast<double>(caster.triangles);
    const bool lamp = pair.light.light.kind != scene::LightKind::directional;
    const double shown = caster.closed ? 0.5 : 1.0; // of its triangles make caps
    const double per_edge = (lamp ? 2.0 : 1.0) * 2.0 * shown;
    double vertices = kVerticesPerFacing * triangles + per_edge * outline_edges(caster);
    if (may_shade_near_plane(pair.scene.camera, pair.light, caster.bounds))
        vertices += shown * triangles * (lamp ? 2.0 : 1.0);
    return vertices;
}

} // namespace

double outline_edges(const CasterView& caster) {
    // A sphere of n triangles has about 4 sqrt(n) edges round its middle; a knot of 50,000 showed
    // 10 sqrt(n).
    const double per_root = caster.convex ? 4.0 : 10.0;
    const auto triangles = static_cast<double>(caster.triangles);
    return std::min(per_root * std::sqrt(triangles), 0.75 * triangles);
}

double crossings(const CasterView& caster) {
    // The area of all sides over that of the hull: edges are as long as triangles are wide. Twice
    // that is what the knot cost on llvmpipe.
    const double sides =
        2.0 * outline_edges(caster) / std::sqrt(static_cast<double>(caster.triangles));
    return caster.convex ? 2.0 : std::max(2.0, sides);
}

engine::Result<Prediction> predict_volume(const PairView& pair, const CasterGroup& casters) {
    if (!pair.scene.wraps_stencil)
        return engine::Error{"this driver's stencil does not wrap on both sides of a face"};
    Prediction prediction;
    double reached_px = 0.0;
    for (const std::uint32_t index : casters.casters) {
        const CasterView& caster = pair.scene.casters[index];
        if (caster.alpha_masked)
            return engine::Error{fmt::format("'{}' has holes that its texture cuts", caster.name)};
        const auto reach = swept_reach(pair.light, caster.bounds, pair.receiver.bounds);
        if (!reach) continue;
        const double area = swept_pixels(pair.scene.camera, {*reach}).area();
        reached_px += area;
        prediction.cost.stencil_fragments += crossings(caster) * area;
        prediction.cost.vertices += vertices_of(pair, caster);
        prediction.cost.draws += 1.0;
    }
    prediction.error_px = kPrecisionFloorPx + 0.25 * penumbra_px(pair, casters);
    prediction.error_area_px = prediction.error_px * shadow_footprint(pair, casters).length_px;
    const double seen_px =
        std::min(reached_px, screen_area_px(pair.scene.camera, pair.receiver.bounds));
    prediction.cost.stencil_fragments += seen_px;
    prediction.cost.taps = seen_px;
    prediction.cost.draws += 1.0;
    return prediction;
}

} // namespace shadows
