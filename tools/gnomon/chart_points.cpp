#include "tools/gnomon/chart_points.hpp"

#include "systems/shadows/cost_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon {

namespace {

/// One half and the rounding of eight bits: a filter's exact half is on neither side.
constexpr float kWrong = 0.502F;
/// Vertices that a triangle costs, as predictions count them.
constexpr double kVerticesPerTriangle = 1.5;
/// What is seen, and whether light reaches it.
constexpr double kRaysPerPixel = 2.0;

} // namespace

gpu::Counters added_by_shadows(gpu::Counters counters, const gpu::Counters& without) {
    for (const auto count :
         {&gpu::Counters::draws,
          &gpu::Counters::triangles,
          &gpu::Counters::map_texels,
          &gpu::Counters::mask_fragments,
          &gpu::Counters::stencil_fragments,
          &gpu::Counters::taps})
        counters.*count -= std::min(counters.*count, without.*count);
    return counters;
}

double
counted_ms(const gpu::Counters& counters, const shadows::FramePlan& plan, std::size_t pixels) {
    shadows::Cost cost;
    cost.vertices = kVerticesPerTriangle * static_cast<double>(counters.triangles);
    cost.colour_fragments = static_cast<double>(counters.mask_fragments);
    cost.stencil_fragments = static_cast<double>(counters.stencil_fragments);
    cost.map_texels = static_cast<double>(counters.map_texels);
    cost.taps = static_cast<double>(counters.taps);
    cost.draws = static_cast<double>(counters.draws);
    for (const shadows::Plan& pair : plan.plans)
        for (const shadows::PlanEntry& entry : pair.entries)
            cost.rays += entry.predicted.cost.rays;
    cost.rays = std::min(cost.rays, kRaysPerPixel * static_cast<double>(pixels));
    return shadows::milliseconds(cost, shadows::llvmpipe_profile());
}

chart::Errors errors_of(const measure::Comparison& comparison, const measure::Figures& figures) {
    chart::Errors errors;
    for (std::size_t i = 0; i < comparison.kind.size(); ++i) {
        if (comparison.kind[i] != measure::PixelKind::valid
            && comparison.kind[i] != measure::PixelKind::undecided)
            continue;
        ++errors.valid_px;
        const float difference = comparison.measured.visibility[i] - comparison.truth.visibility[i];
        if (std::abs(difference) > kWrong) ++errors.wrong_px;
    }
    errors.error_px = figures.error_px;
    errors.edge_px = figures.edge_px;
    const auto known = [](const measure::Figure& figure) {
        return figure.known() ? figure.value() : 0.0;
    };
    errors.precision_floor_px = known(figures.precision_floor_px);
    errors.half_pixel_floor_px = known(figures.half_pixel_floor_px);
    return errors;
}

void add_facts(
    chart::Point& point,
    const measure::Figures& figures,
    const gpu::Counters& counters,
    std::size_t bytes) {
    const auto fact = [&](const char* name, double value) {
        if (value != 0.0) point.facts.emplace_back(name, fmt::format("{:.4g}", value));
    };
    const auto figure = [&](const char* name, const measure::Figure& value) {
        if (value.known()) point.facts.emplace_back(name, fmt::format("{:.4g}", value.value()));
    };
    fact("dark for lit, px", figures.false_shadow_px);
    fact("lit for dark, px", figures.light_leak_px);
    fact("largest wrong region away from edges, px", figures.interior.largest_px);
    figure("mean distance of edges, px", figures.chamfer_px);
    figure("bias, px", figures.bias_px);
    fact("draws", static_cast<double>(counters.draws));
    fact("triangles", static_cast<double>(counters.triangles));
    fact("map texels", static_cast<double>(counters.map_texels));
    fact("look-ups", static_cast<double>(counters.taps));
    fact("mask fragments", static_cast<double>(counters.mask_fragments));
    fact("stencil fragments", static_cast<double>(counters.stencil_fragments));
    fact("device memory, MB", static_cast<double>(bytes) / 1e6);
}

} // namespace gnomon
