#include "tools/chart/beaten_picks.hpp"

#include "engine/core/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/chart/pareto.hpp"

namespace chart {

namespace {

std::string place(const Point& point, Across across, Up up) {
    return fmt::format(
        "{} ({}: {:.4g}, {}: {:.4g})",
        point.name,
        short_title_of(across),
        value(point, across).value_or(0.0),
        short_title_of(up),
        value(point, up).value_or(0.0));
}

/// The front's point that is no worse on both axes.
const Point& beater(
    const Chart& chart, const std::vector<bool>& front, const Point& pick, Across across, Up up) {
    const auto found =
        std::find_if(chart.points.begin(), chart.points.end(), [&](const Point& other) {
            return front[static_cast<std::size_t>(&other - chart.points.data())]
                   && std::max(*value(other, across), 0.0) <= std::max(*value(pick, across), 0.0)
                   && *value(other, up) <= *value(pick, up);
        });
    CHECK(found != chart.points.end());
    return *found;
}

} // namespace

std::vector<std::string> beaten_picks(const Chart& chart, Across across, Up up) {
    std::vector<std::string> sentences;
    const std::vector<bool> front = on_front(chart, across, up);
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const Point& pick = chart.points[i];
        if (!pick.budget_px || front[i]) continue;
        if (!value(pick, across) || !value(pick, up)) {
            sentences.push_back(
                fmt::format("{}: {} has no place on the chart", chart.title(), pick.name));
            continue;
        }
        sentences.push_back(fmt::format(
            "{}: {} is beaten by {}",
            chart.title(),
            place(pick, across, up),
            place(beater(chart, front, pick, across, up), across, up)));
    }
    return sentences;
}

} // namespace chart
