#include "systems/shadows/textures/texture_prediction.hpp"

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/light_samples.hpp"
#include "systems/shadows/maps/map_error.hpp"
#include "systems/shadows/textures/texture_view.hpp"
#include "systems/shadows/volumes/swept_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace shadows {

namespace {

/// What rasterisers and tracers disagree by, px of every edge: a shift of 1/16 px in a random
/// direction, (2 / pi) / 16.
constexpr double kPrecisionFloorPx = 0.04;
/// kTextureEdgeTexels where a caster darkens itself: coverage is then guessed from two depths.
constexpr double kOwnEdgeTexels = 0.19;
/// Texels may be that many times as large as the accepted error: what is thinner is lost.
constexpr double kLargestTexelPerBudget = 4.0;
/// Look-ups of the mask: four texels for each pixel.
constexpr double kTapsPerPixel = 4.0;
/// What a texel costs, in texels of a map: its samples, and 20 ns against 3 for making one of them
/// on llvmpipe.
constexpr double kMapTexelsPerTexel = kSamplesPerSide * kSamplesPerSide + 7.0;
/// Receivers that share a texture: those behind one group, not all of the light's.
constexpr double kReceiversPerTexture = 4.0;
/// Passes besides the casters' draws: the texture's two, the mask.
constexpr double kOwnDraws = 3.0;

/// A texture of one texel at the place where the shadow meets the receiver, pixels.
double footprint_of_one(
    const PairView& pair,
    const CasterGroup& casters,
    const TextureView& view,
    const SweptReach& at) {
    const scene::CameraView& camera = pair.scene.camera;
    const glm::dvec3 shown = glm::clamp(camera.position, at.bounds.min, at.bounds.max);
    const double side = std::max(side_at(view, shown), side_at(view, casters.bounds.centre()));
    // As texel_footprint_px has it, but where the shadow is instead of where the receiver is.
    return texel_footprint_px(pair, side) * typical_distance(camera, pair.receiver.bounds)
           / typical_distance(camera, at.bounds);
}

int size_for(const PairView& pair, double footprint, double edge_texels) {
    if (pair.wish.map_size) return *pair.wish.map_size;
    const double largest = std::min(
        kLargestTexelPerBudget * pair.budget_px,
        std::max(pair.budget_px - kPrecisionFloorPx, 0.01) / edge_texels);
    int size = kSmallestTexture;
    while (size < kLargestTexture && footprint / size > largest)
        size *= 2;
    return size;
}

/// Whether the receiver is one of the casters, and may darken itself.
bool may_darken_itself(const PairView& pair, const CasterGroup& casters) {
    for (const std::uint32_t index : casters.casters) {
        const CasterView& caster = pair.scene.casters[index];
        if (caster.id == pair.receiver.entity && !caster.convex
            && stands_before(caster.bounds, pair.receiver))
            return true;
    }
    return false;
}

/// Whether something that receives without casting may catch the shadow before the receiver.
bool may_be_caught(const PairView& pair, const CasterGroup& casters) {
    const ShadowScene& scene = pair.scene;
    return !scene.everything_casts
           && std::any_of(
               scene.receivers.begin(), scene.receivers.end(), [&](const ReceiverView& other) {
                   return !other.casts && other.id != pair.receiver.id
                          && can_shadow(pair.light, casters.bounds, other.bounds)
                          && can_shadow(pair.light, other.bounds, pair.receiver.bounds);
               });
}

/// Where the shadow falls, and how large a texture of one texel is there.
struct Lie {
    SweptReach reach;
    double footprint = 0.0; ///< pixels
    double edge_texels = kTextureEdgeTexels;
};

engine::Result<std::optional<Lie>> lie_of(const PairView& pair, const CasterGroup& casters) {
    const auto view = fit_texture(pair.light, {&casters.bounds, 1}, {}, 1, 0);
    if (!view) return view.error();
    const auto reach = swept_reach(pair.light, casters.bounds, pair.receiver.bounds);
    if (!reach) return std::optional<Lie>();
    return std::optional<Lie>(
        {*reach,
         footprint_of_one(pair, casters, *view, *reach),
         may_darken_itself(pair, casters) ? kOwnEdgeTexels : kTextureEdgeTexels});
}

/// Of a layout: pixels of displacement, per length of edge.
double error_of(const Lie& lie, const TextureLayout& layout, double penumbra) {
    const double edges = lie.edge_texels * lie.footprint / layout.size;
    const double soft =
        layout.samples == 1 ? 0.25 * penumbra : sampling_error(layout.samples) * penumbra;
    return kPrecisionFloorPx + edges + soft;
}

TextureLayout layout_for(const PairView& pair, const Lie& lie, double penumbra) {
    TextureLayout layout;
    layout.size = size_for(pair, lie.footprint, lie.edge_texels);
    if (!has_size(pair.light)) return layout;
    if (pair.wish.samples) {
        layout.samples = std::clamp(*pair.wish.samples, 1, most_samples(layout.size));
        return layout;
    }
    if (error_of(lie, layout, penumbra) <= pair.budget_px) return layout;
    // The points' hard edges are off in all directions, and half of the budget is left to them.
    layout.samples =
        std::min(samples_for(penumbra, 0.5 * pair.budget_px), most_samples(layout.size));
    return layout;
}

} // namespace

int most_samples(int size) {
    constexpr int kBytesPerTexel = 16;
    return std::max(1, (64 << 20) / (kBytesPerTexel * size * size));
}

engine::Result<Prediction> predict_texture(const PairView& pair, const CasterGroup& casters) {
    const auto lie = lie_of(pair, casters);
    if (!lie) return lie.error();
    if (!*lie) return Prediction{}; // no shadow of theirs falls there
    const double penumbra = penumbra_px(pair, casters);
    const TextureLayout layout = layout_for(pair, **lie, penumbra);
    const ShadowFootprint shadow = shadow_footprint(pair, casters);
    Prediction prediction;
    prediction.error_px = error_of(**lie, layout, penumbra);
    // Truth lets light through what does not cast, and the shadow with it.
    if (may_be_caught(pair, casters))
        prediction.error_px += shadow.length_px / (2.0 * std::numbers::pi);
    prediction.error_area_px = prediction.error_px * shadow.length_px;
    const double texels = static_cast<double>(layout.size) * layout.size;
    const double area = swept_pixels(pair.scene.camera, {(*lie)->reach}).area();
    Cost& cost = prediction.cost;
    cost.vertices = layout.samples * static_cast<double>(casters.triangles);
    cost.map_texels = layout.samples * kMapTexelsPerTexel * texels / kReceiversPerTexture;
    cost.taps = layout.samples * kTapsPerPixel * area;
    cost.draws = layout.samples * (kOwnDraws + static_cast<double>(casters.casters.size()));
    return prediction;
}

TextureLayout texture_layout(const PairView& pair, const CasterGroup& casters) {
    const auto lie = lie_of(pair, casters);
    if (!lie || !*lie) return {pair.wish.map_size.value_or(kSmallestTexture), 1};
    return layout_for(pair, **lie, penumbra_px(pair, casters));
}

TextureLayout finer(const TextureLayout& a, const TextureLayout& b) {
    return {std::max(a.size, b.size), std::max(a.samples, b.samples)};
}

} // namespace shadows
