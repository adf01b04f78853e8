// Names beside points, as many as have room.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/chart/pareto.hpp"

namespace chart {

struct Box {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
};

/// A name and the point that it belongs to, px.
struct Wanted {
    Place point;
    std::string text;
};

/// Where names go, one after the other: beside, above or below their points, where they cover
/// neither a point nor a name that has its place, inside `room`. Nothing: no place was free.
/// @return the left ends of their base lines
std::vector<std::optional<Place>>
place_labels(std::span<const Wanted> wanted, std::span<const Place> points, const Box& room);

} // namespace chart
