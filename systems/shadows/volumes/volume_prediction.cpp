#include "systems/shadows/volumes/volume_prediction.hpp"

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/maps/map_error.hpp"
#include "systems/shadows/volumes/caster_proxy.hpp"
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
/// @param drawn its triangles, or its proxy's
double vertices_of(const PairView& pair, const CasterView& caster, std::uint32_t drawn) {
    const auto triangles = static_cast<double>(drawn);
    const bool lamp = pair.light.light.kind != scene::LightKind::directional;
    const double shown = caster.closed ? 0.5 : 1.0; // of its triangles make caps
    const double per_edge = (lamp ? 2.0 : 1.0) * 2.0 * shown;
    double vertices = kVerticesPerFacing * triangles + per_edge * outline_edges(caster, drawn);
    if (may_shade_near_plane(pair.scene.camera, pair.light, caster.bounds))
        vertices += shown * triangles * (lamp ? 2.0 : 1.0);
    return vertices;
}

/// Notes which proxy, or that none, is drawn for a caster. @return the triangles that are drawn
std::uint32_t take_level(
    const PairView& pair,
    const CasterGroup& casters,
    std::size_t place,
    double allowance_px,
    Prediction& prediction) {
    const CasterView& caster = pair.scene.casters[casters.casters[place]];
    const int level = proxy_level(pair, casters, caster, allowance_px);
    std::string note;
    if (pair.wish.proxy) note = why_not_proxy(pair, caster, level);
    if (level > 0) {
        prediction.proxy_levels.resize(casters.casters.size());
        prediction.proxy_levels[place] = static_cast<std::uint8_t>(level);
        if (note.empty())
            note = fmt::format(
                "'{}' simplified to its proxy {} unless drawn anyway", caster.name, level);
    }
    if (!note.empty()) prediction.note += (prediction.note.empty() ? "" : "; ") + note;
    return level > 0 ? caster.proxies[static_cast<std::size_t>(level - 1)].triangles
                     : caster.triangles;
}

} // namespace

double outline_edges(const CasterView& caster, std::uint32_t drawn) {
    // As many fewer as triangles are wider.
    const double coarser = static_cast<double>(drawn) / std::max(caster.triangles, 1U);
    return caster.outline_edges * std::sqrt(coarser);
}

double crossings(const CasterView& caster) {
    return 2.0 * caster.outline_share;
}

engine::Result<Prediction> predict_volume(const PairView& pair, const CasterGroup& casters) {
    if (!pair.scene.wraps_stencil)
        return engine::Error{"this driver's stencil does not wrap on both sides of a face"};
    Prediction prediction;
    prediction.error_px = kPrecisionFloorPx + 0.25 * penumbra_px(pair, casters);
    const double allowance_px = pair.budget_px - prediction.error_px;
    double proxy_px = 0.0;
    double reached_px = 0.0;
    for (std::size_t i = 0; i < casters.casters.size(); ++i) {
        const CasterView& caster = pair.scene.casters[casters.casters[i]];
        if (caster.alpha_masked)
            return engine::Error{fmt::format("'{}' has holes that its texture cuts", caster.name)};
        const auto reach = swept_reach(pair.light, caster.bounds, pair.receiver.bounds);
        if (!reach) continue;
        const std::uint32_t drawn = take_level(pair, casters, i, allowance_px, prediction);
        if (!prediction.proxy_levels.empty() && prediction.proxy_levels[i] > 0)
            proxy_px = std::max(
                proxy_px, proxy_error_px(pair, casters, caster, prediction.proxy_levels[i]));
        const double area = swept_pixels(pair.scene.camera, {*reach}).area();
        reached_px += area;
        prediction.cost.stencil_fragments += crossings(caster) * area;
        prediction.cost.vertices += vertices_of(pair, caster, drawn);
        prediction.cost.draws += 1.0;
    }
    prediction.error_px += proxy_px;
    prediction.error_area_px = prediction.error_px * shadow_footprint(pair, casters).length_px;
    const double seen_px =
        std::min(reached_px, screen_area_px(pair.scene.camera, pair.receiver.bounds));
    prediction.cost.stencil_fragments += seen_px;
    prediction.cost.taps = seen_px;
    prediction.cost.draws += 1.0;
    return prediction;
}

} // namespace shadows
