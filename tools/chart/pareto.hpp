// Which points are worth their cost.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/chart/chart.hpp"

namespace chart {

struct Place {
    double x = 0.0;
    double y = 0.0;
};

/// The points that no other one beats: none is as good in both and better in one. Less is better.
/// @return indices, by rising x; equal places in their order
std::vector<std::size_t> pareto_front(std::span<const Place> places);

/// Whether nothing beats each point of Chart::all() on these axes. Peers are held against peers,
/// the truth against nobody; a cost that noise made negative is none.
std::vector<bool> on_front(const Chart& chart, Across across, Up up);

} // namespace chart
