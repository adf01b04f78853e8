#include "tools/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace chart {

namespace {

std::optional<double> ratio(double part, double whole) {
    return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

std::optional<double> percent(double part, double whole) {
    return ratio(100.0 * part, whole);
}

struct Names {
    std::string_view word;
    std::string_view short_title;
    std::string_view title;
};

Names names_of(Up up) {
    switch (up) {
    case Up::wrong_percent:
        return {"wrong_percent", "wrong %", "wrong pixels, %"};
    case Up::eps_px:
        return {"eps_px", "eps px", "error per px of true edge, px"};
    case Up::error_px:
        break;
    }
    return {"error_px", "error px", "sum of |V - V*|, px"};
}

} // namespace

Errors& Errors::operator+=(const Errors& other) {
    for (const auto count :
         {&Errors::valid_px,
          &Errors::wrong_px,
          &Errors::error_px,
          &Errors::edge_px,
          &Errors::precision_floor_px,
          &Errors::half_pixel_floor_px})
        this->*count += other.*count;
    return *this;
}

std::string_view word_of(Across across) {
    return across == Across::measured ? "measured" : "predicted";
}

std::string_view short_title_of(Across across) {
    return across == Across::measured ? "measured ms" : "predicted ms";
}

std::string_view title_of(Across across) {
    return across == Across::measured ? "what shadows add to a frame, ms"
                                      : "counted work x committed coefficients, ms";
}

std::string_view word_of(Up up) {
    return names_of(up).word;
}

std::string_view short_title_of(Up up) {
    return names_of(up).short_title;
}

std::string_view title_of(Up up) {
    return names_of(up).title;
}

std::optional<double> value(const Point& point, Across across) {
    return across == Across::measured ? point.measured_ms : point.predicted_ms;
}

std::optional<double> value(const Point& point, Up up) {
    if (!point.errors) return up == Up::wrong_percent ? point.wrong_percent : std::nullopt;
    const Errors& errors = *point.errors;
    switch (up) {
    case Up::wrong_percent:
        return percent(errors.wrong_px, errors.valid_px);
    case Up::eps_px:
        return ratio(errors.error_px, errors.edge_px);
    case Up::error_px:
        break;
    }
    return errors.error_px;
}

std::string Chart::title() const {
    return light.empty() ? scene : fmt::format("{}, light '{}'", scene, light);
}

std::vector<const Point*> Chart::all() const {
    std::vector<const Point*> all;
    for (const Point& point : points)
        all.push_back(&point);
    for (const Point& peer : peers)
        all.push_back(&peer);
    return all;
}

Up usual_up(std::span<const Chart> charts) {
    const bool soft =
        std::any_of(charts.begin(), charts.end(), [](const Chart& chart) { return chart.soft; });
    return soft ? Up::eps_px : Up::wrong_percent;
}

std::vector<Floor> floors(const Chart& chart, Up up) {
    if (chart.soft && up == Up::wrong_percent) return {};
    for (const Point& point : chart.points) {
        if (!point.errors) continue; // every point has the same truth
        const Errors& errors = *point.errors;
        const auto on_axis = [&](double floor_px) {
            if (up == Up::error_px) return std::optional(floor_px);
            return up == Up::eps_px ? ratio(floor_px, errors.edge_px)
                                    : percent(floor_px, errors.valid_px);
        };
        std::vector<Floor> lines;
        if (const auto at = on_axis(errors.precision_floor_px); at && *at > 0.0)
            lines.push_back({"precision floor", *at});
        if (const auto at = on_axis(errors.half_pixel_floor_px); at && *at > 0.0)
            lines.push_back({"half-pixel floor", *at});
        return lines;
    }
    return {};
}

} // namespace chart
