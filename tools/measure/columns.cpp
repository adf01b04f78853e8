#include "tools/measure/columns.hpp"

#include <array>

namespace measure {

namespace {

template <class Group, class Member>
Group group_of(Member Group::*member);

/// A member of a group, or a member of its member.
template <auto member, auto... rest, class Group>
auto& member_of(Group& group) {
    if constexpr (sizeof...(rest) == 0)
        return group.*member;
    else
        return member_of<rest...>(group.*member);
}

void assign(double& member, const Figure& figure) {
    member = figure.value();
}

void assign(bool& member, const Figure& figure) {
    member = figure.value() != 0.0;
}

void assign(Figure& member, const Figure& figure) {
    member = figure;
}

template <auto member, auto... rest>
constexpr Access<decltype(group_of(member))> field = {
    [](const decltype(group_of(member))& group) {
        return Figure(member_of<member, rest...>(group));
    },
    [](decltype(group_of(member))& group, const Figure& figure) {
        assign(member_of<member, rest...>(group), figure);
    }};

using F = Figures;
constexpr int kHidden = kNotInTable;

// One figure, one row.
// clang-format off

constexpr auto kStill = std::to_array<FigureColumn<F>>({
    {"valid_px", "px", "pixels that can be compared", kHidden, field<&F::valid_px>},
    {"invalid_share", "", "pixels that show another surface than the truth", kHidden,
     field<&F::invalid_share>},
    {"undecided_share", "", "pixels away from edges whose truth is not sure", kHidden,
     field<&F::undecided_share>},
    {"grazing_px", "px", "pixels lit by less than one degree", kHidden, field<&F::grazing_px>},
    {"grazing_wrong_px", "px", "wrong ones among them", kHidden, field<&F::grazing_wrong_px>},
    {"edge_px", "px", "length of the true edge", 0, field<&F::edge_px>},
    {"penumbra_px", "px", "pixels of true penumbra", kHidden, field<&F::penumbra_px>},
    {"false_shadow_px", "px", "dark, should be lit", 0, field<&F::false_shadow_px>},
    {"light_leak_px", "px", "lit, should be dark", 0, field<&F::light_leak_px>},
    {"false_shadow_in_px", "px", "the same, farther than 1 px from true edges", kHidden,
     field<&F::interior, &InteriorErrors::false_shadow_px>},
    {"light_leak_in_px", "px", "the same, farther than 1 px from true edges", kHidden,
     field<&F::interior, &InteriorErrors::light_leak_px>},
    {"false_shadow_edge_px", "px", "the same, within 1 px of true edges", kHidden,
     {[](const F& f) { return Figure(f.false_shadow_px - f.interior.false_shadow_px); }}},
    {"light_leak_edge_px", "px", "the same, within 1 px of true edges", kHidden,
     {[](const F& f) { return Figure(f.light_leak_px - f.interior.light_leak_px); }}},
    {"largest_in_px", "px", "largest connected wrong region in the interior", kHidden,
     field<&F::interior, &InteriorErrors::largest_px>},
    {"components_in", "/1000px", "wrong regions in the interior per 1000 valid pixels: acne", kHidden,
     field<&F::interior, &InteriorErrors::components>},
    {"band_share", "", "valid pixels within the technique's own resolution of a true edge", 3,
     field<&F::band_share>},
    {"false_shadow_far_px", "px", "dark for lit beyond the technique's own resolution", 0,
     field<&F::far_false_shadow_px>},
    {"light_leak_far_px", "px", "lit for dark beyond the technique's own resolution", 0,
     field<&F::far_light_leak_px>},
    {"largest_far_px", "px", "largest connected wrong region beyond the technique's own resolution", 0,
     field<&F::far_largest_px>},
    {"chamfer_px", "px", "mean distance between measured and true edge", 2, field<&F::chamfer_px>},
    {"hausdorff95_px", "px", "95th percentile of that distance", 2, field<&F::hausdorff95_px>},
    {"boundary_f1", "", "share of the edges within 1 px of each other", 3, field<&F::boundary_f1>},
    {"error_px", "px", "sum of |V - V*|", kHidden, field<&F::error_px>},
    {"eps_px", "px", "error per px of true edge", 3, field<&F::eps_px>},
    {"bias_px", "px", "the same with its sign: positive is too much light", 3, field<&F::bias_px>},
    {"mean_error", "", "error per valid pixel", 5, field<&F::mean_error>},
    {"double_dark_px", "px", "darker than shading with the true mask, where no light falls", 0,
     field<&F::double_dark_px>},
    {"precision_floor_px", "px", "error of a 1/16 px shift, or of another sampling of a soft light", kHidden,
     field<&F::precision_floor_px>},
    {"half_pixel_floor_px", "px", "error of a 1/2 px shift", kHidden,
     field<&F::half_pixel_floor_px>},
    {"over_precision_floor", "x", "wrong pixels (soft: error) / precision floor", 1,
     field<&F::over_precision_floor>},
    {"over_half_pixel_floor", "x", "wrong pixels (soft: error) / half-pixel floor", 2,
     field<&F::over_half_pixel_floor>},
    {"copied_truth", "", "1: better than the precision floor, which no drawing can be", kHidden,
     field<&F::copied_truth>},
    {"flip_mean", "", "FLIP between the lit pictures, mean: how different they look, 0 to 1", 4,
     field<&F::flip_mean>},
    {"flip_p99", "", "the same, 99th percentile of the pixels", kHidden, field<&F::flip_p99>},
});

using M = MotionFigures;

constexpr auto kMotion = std::to_array<FigureColumn<M>>({
    {"motion_frames", "", "frames of the moving sequence", kHidden, field<&M::frames>},
    {"changed_px", "px", "pixels that change while nothing moves", 0, field<&M::changed_px>},
    {"mean_edge_px", "px", "length of the true edge, mean over the sequence", kHidden,
     field<&M::mean_edge_px>},
    {"tracked_points", "", "surface points seen in every frame", kHidden,
     field<&M::tracked_points>},
    {"flicker_per_px", "/px", "flips per px of true edge and frame, beyond the truth's own", 3,
     field<&M::flicker_per_px>},
    {"truth_flicker_per_px", "/px", "the same of the truth, sampled on a second grid", 3,
     field<&M::truth_flicker_per_px>},
    {"flicker_ratio", "x", "flicker over the truth's", 2, field<&M::flicker_ratio>},
    {"pop", "", "largest sudden change of a 32 px tile beyond the truth's own", 3, field<&M::pop>},
    {"crawl_px", "px", "how much pieces of edge move to and fro from frame to frame, rms", 3,
     field<&M::crawl_px>},
    {"stale_px", "px", "how far edges stand behind because they are not redrawn in every frame", 3,
     field<&M::lag, &LagFigures::stale_px>},
    {"stale_p95_px", "px", "the same, 95th percentile of the edge", 2,
     field<&M::lag, &LagFigures::stale_p95_px>},
    {"age_mean", "frames", "by which a shadow stands behind what moved, mean", kHidden,
     field<&M::lag, &LagFigures::age_mean>},
    {"age_max", "frames", "the same, the oldest", kHidden, field<&M::lag, &LagFigures::age_max>},
});

using T = Timing;

constexpr auto kTiming = std::to_array<FigureColumn<T>>({
    {"median_ms", "ms", "one frame with shadows, median", kHidden, field<&T::median_ms>},
    {"p99_ms", "ms", "one frame with shadows, 99th percentile", 2, field<&T::p99_ms>},
    {"without_median_ms", "ms", "the same frame without shadows, median", kHidden, field<&T::without_median_ms>},
    {"shadow_ms", "ms", "what shadows add to the median frame", 2,
     {[](const T& t) { return Figure(t.median_ms - t.without_median_ms); }}},
});

using C = Counters;

constexpr auto kCounters = std::to_array<FigureColumn<C>>({
    {"draws", "", "draw calls for shadows", kHidden, field<&C::draws>},
    {"triangles", "", "triangles drawn for shadows", kHidden, field<&C::triangles>},
    {"map_texels", "", "map texels written", kHidden, field<&C::map_texels>},
    {"mask_fragments", "", "mask pixels shaded", kHidden, field<&C::mask_fragments>},
    {"stencil_fragments", "", "stencil pixels touched", kHidden, field<&C::stencil_fragments>},
    {"taps", "", "map texels read", kHidden, field<&C::taps>},
    {"gpu_bytes", "B", "memory that shadows hold on the device", kHidden, field<&C::gpu_bytes>},
});

// clang-format on

} // namespace

template <>
std::span<const FigureColumn<Figures>> columns_of() {
    return kStill;
}

template <>
std::span<const FigureColumn<MotionFigures>> columns_of() {
    return kMotion;
}

template <>
std::span<const FigureColumn<Timing>> columns_of() {
    return kTiming;
}

template <>
std::span<const FigureColumn<Counters>> columns_of() {
    return kCounters;
}

} // namespace measure
