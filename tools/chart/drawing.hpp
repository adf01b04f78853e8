// A chart as SVG: what a page shows, and what stands in a manual.

#pragma once

#include <string>

#include "tools/chart/chart.hpp"
#include "tools/chart/marks.hpp"

namespace chart {

inline constexpr int kChartWidth = 1080;
inline constexpr int kChartHeight = 620;

/// Draws those points that have a value on both axes.
/// Every point is a group with class "p", its place in Chart::all() as data-point, a name for
/// screen readers and a tabindex; every line of the legend has class "key" and data-series.
std::string drawing(const Chart& chart, const Series& series, Across across, Up up);

/// A drawing that is a file of its own: with its colours.
std::string svg_file(const std::string& drawing);

} // namespace chart
