// What a frame that was drawn becomes on a chart: its cost, its errors, and what stands beside it.

#pragma once

#include "engine/gpu/frame.hpp"
#include "systems/shadows/plan.hpp"

#include <cstddef>

#include "tools/chart/chart.hpp"
#include "tools/measure/figures.hpp"

namespace gnomon {

/// Counts of a frame with shadows, less those of the frame itself.
gpu::Counters added_by_shadows(gpu::Counters counters, const gpu::Counters& without);

/// What was counted, at what it costs, ms. Rays are not counted but as their plans predict them,
/// two a pixel at most: the plans of receivers behind one another predict the same pixels again.
/// @param pixels of the picture
double
counted_ms(const gpu::Counters& counters, const shadows::FramePlan& plan, std::size_t pixels);

/// Wrong is what differs by more than a half, of the pixels whose surface is seen and turned to the
/// light. Undecided ones count: other engines' judges know no such, and leaving them out would
/// flatter.
chart::Errors errors_of(const measure::Comparison& comparison, const measure::Figures& figures);

/// What stands beside a point for people. @param bytes that shadows hold on the device
void add_facts(
    chart::Point& point,
    const measure::Figures& figures,
    const gpu::Counters& counters,
    std::size_t bytes);

} // namespace gnomon
