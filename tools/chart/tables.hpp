// Charts for other programs.

#pragma once

#include <span>
#include <string>

#include "tools/chart/chart.hpp"

namespace chart {

/// RFC 4180: a row a point: scene, light (empty: all of them), point, series, peer (0 or 1), costs,
/// errors, budget_px, front (on usual_up() and measured time, without any on predicted).
/// What is not known is an empty field.
std::string csv(std::span<const Chart> charts);

/// {"charts": [{scene, light, floors, points: [{...}], refusals: [{name, reason}]}]}: the same, and
/// why settings have no point. Without pictures.
std::string json(std::span<const Chart> charts);

} // namespace chart
