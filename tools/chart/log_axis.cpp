#include "tools/chart/log_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace chart {

namespace {

constexpr std::array kSteps = {1.0, 2.0, 5.0};
constexpr double kSlack = 1.0 + 1e-9; ///< powers of ten are not exact

int decade_of(double value) {
    return static_cast<int>(std::floor(std::log10(value)));
}

double step_below(double value) {
    const int decade = decade_of(value);
    double best = std::pow(10.0, decade - 1);
    for (int n = decade - 1; n <= decade; ++n)
        for (const double step : kSteps)
            if (step * std::pow(10.0, n) <= value * kSlack) best = step * std::pow(10.0, n);
    return best;
}

double step_above(double value) {
    const int decade = decade_of(value);
    for (int n = decade; n <= decade + 1; ++n)
        for (const double step : kSteps)
            if (step * std::pow(10.0, n) * kSlack >= value) return step * std::pow(10.0, n);
    return std::pow(10.0, decade + 2);
}

} // namespace

LogAxis::LogAxis(std::span<const double> values, double from, double to, double gutter)
    : from_(from),
      start_(from),
      to_(to) {
    double least = INFINITY;
    double most = 0.0;
    for (const double value : values) {
        if (!(value > 0.0)) {
            start_ = from + (to > from ? gutter : -gutter);
            continue;
        }
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (most == 0.0) return;
    lowest_ = step_below(least);
    highest_ = step_above(most);
    if (highest_ <= lowest_ * kSlack) highest_ = step_above(lowest_ * 1.5);
}

double LogAxis::place(double value) const {
    if (!(value > 0.0)) return (from_ + start_) / 2.0;
    const double share = std::log(value / lowest_) / std::log(highest_ / lowest_);
    return start_ + (to_ - start_) * std::clamp(share, 0.0, 1.0);
}

std::vector<Tick> LogAxis::ticks() const {
    std::vector<Tick> ticks;
    const bool is_short = highest_ / lowest_ < 1000.0;
    for (int n = decade_of(lowest_) - 1; n <= decade_of(highest_) + 1; ++n)
        for (const double step : kSteps) {
            const double value = step * std::pow(10.0, n);
            if (value * kSlack < lowest_ || value > highest_ * kSlack) continue;
            if (step == 1.0 || is_short)
                ticks.push_back({place(value), fmt::format("{:g}", value), step == 1.0});
        }
    return ticks;
}

} // namespace chart
