// The gate of the picker: what it picks is worth its cost.

#pragma once

#include <string>
#include <vector>

#include "tools/chart/chart.hpp"

namespace chart {

/// A sentence for each pick (a point with a budget) that another setting beats: at most as dear and
/// as wrong, and less in one. Empty when all picks lie on the front. A pick that lacks a value on
/// an axis is a sentence, too; peers and the truth beat nobody.
std::vector<std::string> beaten_picks(const Chart& chart, Across across, Up up);

} // namespace chart
