// Names beside points, as many as have room.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// What a point's mark covers.
Box mark_box(const Place& point);
/// What a name covers. @param start the left end of its base line
Box text_box(const Place& start, std::string_view text);

/// Where names go, one after the other: beside, above or below their points, where they cover
/// nothing that is `taken` and no name that has its place, inside `room`. Nothing: no place was
/// free.
/// @return the left ends of their base lines
std::vector<std::optional<Place>>
place_labels(std::span<const Wanted> wanted, std::vector<Box> taken, const Box& room);

} // namespace chart
