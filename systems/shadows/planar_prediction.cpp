#include "systems/shadows/planar_prediction.hpp"

#include "systems/shadows/cost_model.hpp"
#include "systems/shadows/error_model.hpp"
#include "systems/shadows/light_samples.hpp"
#include "systems/shadows/planar_projection.hpp"
#include "systems/shadows/screen_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace shadows {

namespace {

/// What rasterisers and tracers disagree by, px of every edge: a shift of 1/16 px in a random
/// direction, (2 / pi) / 16.
constexpr double kPrecisionFloorPx = 0.04;
/// Below this a sun's shadows are 57 times as long as their casters are high, and shading fades.
constexpr double kLeastSunSine = 0.0174524; // 1 degree
/// Errors per length of edge, in widths of the penumbra. Two centred ramps differ by a quarter of
/// what they differ in width; a plateau's skirt is right outside and dark inside.
constexpr double kHardError = 0.25;
constexpr double kPlateauError = 0.25;
/// The same of a texture's texels, read bilinearly. Source: simulated for edges in all directions.
constexpr double kTexelError = 0.332;
/// Draws of a receiver besides its casters: its mark, the wipe.
constexpr double kOwnDraws = 2.0;
/// Those of a soft one: they are summed up apart, too.
constexpr double kOwnSoftDraws = 4.0;

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

/// What a shadow is on the receiver and on screen.
struct Lie {
    engine::WorldAabb bounds; ///< of the hard shadow
    double penumbra_m = 0.0;  ///< the widest
    double penumbra_px = 0.0;
    double base_px = 0.0;    ///< error of any way to draw it
    double stretch_px = 0.0; ///< pixels on the receiver for a metre across the light at the caster
};

Lie lie_of(
    const PairView& pair,
    const CasterGroup& casters,
    const LitPlane& plane,
    const engine::WorldAabb& shadow) {
    Lie lie;
    lie.bounds = shadow;
    const double sine =
        std::max(sine_of_elevation(pair.light, plane, shadow.centre()), kLeastSunSine);
    const double cotangent = std::sqrt(1.0 - std::min(1.0, sine * sine)) / sine;
    const double pixel = pixel_size_at(pair.scene.camera, shadow);
    lie.penumbra_m =
        penumbra_width(pair.light, casters.bounds, highest_corner(plane, casters.bounds), sine);
    lie.penumbra_px = lie.penumbra_m / pixel;
    lie.base_px = kPrecisionFloorPx + pair.receiver.residual * cotangent / pixel;
    // Longer by the sine along one of two directions, and by the distance behind the caster.
    const double height = highest_corner(plane, casters.bounds);
    const double growth = plane.light_height / (plane.light_height - height);
    lie.stretch_px = (std::isinf(plane.light_height) ? 1.0 : growth) / std::sqrt(sine) / pixel;
    return lie;
}

/// A caster as it is drawn.
struct Level {
    std::string_view way = planar_way::kGeometry;
    double error_px = 0.0;
    double triangles = 0.0;
};

constexpr double kTrianglesPerBox = 12.0;
constexpr std::array kBoxLevels = {planar_way::kBox, planar_way::kBoxes};
constexpr std::array kBoxCounts = {1.0, 8.0}; ///< at most, as scene::make_box_sets() has them

/// @param which of kBoxLevels. No value where a caster has no such boxes.
std::optional<Level>
box_level(const PairView& pair, const CasterGroup& casters, const Lie& lie, std::size_t which) {
    Level level{kBoxLevels[which], 0.0, 0.0};
    for (const std::uint32_t index : casters.casters) {
        const double deviation = pair.scene.casters[index].box_deviation[which];
        if (std::isinf(deviation)) return std::nullopt;
        level.error_px = std::max(level.error_px, deviation * lie.stretch_px);
        level.triangles += kBoxCounts[which] * kTrianglesPerBox;
    }
    return level;
}

/// The least to draw that leaves no more error than this; the casters themselves where nothing
/// else does. Errors: what is wished for does not exist.
engine::Result<Level>
level_of(const PairView& pair, const CasterGroup& casters, const Lie& lie, double error_px) {
    const Level whole{planar_way::kGeometry, 0.0, static_cast<double>(casters.triangles)};
    const std::string_view wished = pair.wish.way ? std::string_view(*pair.wish.way) : "";
    for (std::size_t which = 0; which < kBoxLevels.size(); ++which) {
        const auto level = box_level(pair, casters, lie, which);
        if (wished == kBoxLevels[which]) {
            if (level) return *level;
            return engine::Error{"its casters have no boxes: they have holes, change their shape, "
                                 "or are as simple as boxes"};
        }
        if (wished.empty() && level && level->error_px <= error_px
            && level->triangles < whole.triangles)
            return *level;
    }
    return whole;
}

/// How the light's size is served.
struct Softness {
    int samples = 1;
    bool plateau = false; ///< in the place of the one sample
    double error_px = 0.0;
};

Softness softness_of(const PairView& pair, const Lie& lie) {
    if (!has_size(pair.light)) return {};
    const bool wished = pair.wish.way == planar_way::kPlateau;
    const double plateau_px = kPlateauError * lie.penumbra_px;
    if (wished && lie.base_px + plateau_px <= pair.budget_px) return {1, true, plateau_px};
    const double hard_px = kHardError * lie.penumbra_px;
    const bool hard = lie.base_px + hard_px <= pair.budget_px;
    const int wanted =
        hard ? 1
             : samples_for(
                 lie.penumbra_px, std::max(pair.budget_px - lie.base_px, kPrecisionFloorPx));
    const int samples = pair.wish.samples.value_or(wanted);
    return {samples, false, samples == 1 ? hard_px : sampling_error(samples) * lie.penumbra_px};
}

/// Work for a look-up.
Cost look_up_cost(double area_px) {
    Cost cost;
    cost.taps = 2.0 * area_px; // what is seen, and the texture
    cost.colour_fragments = area_px;
    cost.draws = 1.0;
    return cost;
}

/// Pixels that the shadow may lie on.
double touched_px(const PairView& pair, const Lie& lie, bool soft) {
    engine::WorldAabb round = lie.bounds;
    if (soft) {
        round.min = glm::max(round.min - 0.5 * lie.penumbra_m, pair.receiver.bounds.min);
        round.max = glm::min(round.max + 0.5 * lie.penumbra_m, pair.receiver.bounds.max);
    }
    return screen_bounds(pair.scene.camera, round).area();
}

/// Work for a shadow that covers `area_px`.
Cost cost_of(
    const PairView& pair,
    const CasterGroup& casters,
    const Lie& lie,
    const Level& level,
    const Softness& softness,
    double area_px) {
    const bool soft = softness.samples > 1 || softness.plateau;
    const double touched = touched_px(pair, lie, soft);
    if (pair.wish.way == planar_way::kTexture) return look_up_cost(touched);
    const double times = static_cast<double>(softness.samples);
    Cost cost;
    cost.vertices = times * level.triangles;
    cost.stencil_fragments = 2.0 * touched;
    cost.colour_fragments = times * std::min(area_px, touched);
    cost.draws = times * static_cast<double>(casters.casters.size());
    cost.draws += soft ? kOwnSoftDraws : kOwnDraws;
    if (soft) cost.taps = touched;
    return cost;
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
    const Lie lie = lie_of(pair, casters, *plane, shadow);
    Prediction prediction;
    const Softness softness = softness_of(pair, lie);
    prediction.error_px = lie.base_px + softness.error_px;
    if (pair.wish.way == planar_way::kTexture)
        prediction.error_px += kTexelError * kKeptTexelPerBudget * pair.budget_px;
    const auto level = level_of(pair, casters, lie, pair.budget_px - prediction.error_px);
    if (!level) return level.error();
    prediction.error_px += level->error_px;
    const ShadowFootprint footprint = shadow_footprint(pair, casters);
    prediction.variant.samples = static_cast<std::uint16_t>(softness.samples);
    prediction.variant.way = level->way;
    for (const std::string_view way : {planar_way::kPlateau, planar_way::kTexture})
        if (pair.wish.way == way) prediction.variant.way = way;
    prediction.error_area_px = prediction.error_px * footprint.length_px;
    prediction.cost = cost_of(pair, casters, lie, *level, softness, footprint.area_px);
    return prediction;
}

bool keeping_pays(const Cost& projected, double area_px) {
    const DeviceProfile profile = llvmpipe_profile();
    return milliseconds(look_up_cost(area_px), profile) < milliseconds(projected, profile);
}

} // namespace shadows
