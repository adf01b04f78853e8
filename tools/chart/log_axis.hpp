// A logarithmic axis that also knows zero: what is not positive lies in a gutter before its start.

#pragma once

#include <span>
#include <string>
#include <vector>

namespace chart {

struct Tick {
    double at = 0.0; ///< along the axis
    std::string label;
    bool whole = false; ///< a power of ten
};

class LogAxis {
public:
    /// From the last 1, 2 or 5 x 10^n below the positive values to the first above; from 0.1 to 1
    /// when there are none.
    /// @param from, to the axis's ends on the picture, the gutter included; either may be larger
    /// @param gutter its length, left out where every value is positive
    LogAxis(std::span<const double> values, double from, double to, double gutter);

    /// Not positive: the middle of the gutter. Beyond an end: that end.
    [[nodiscard]] double place(double value) const;
    [[nodiscard]] bool knows_zero() const { return start_ != from_; }
    /// Where the gutter ends and the logarithm begins.
    [[nodiscard]] double start() const { return start_; }
    [[nodiscard]] double lowest() const { return lowest_; }
    [[nodiscard]] double highest() const { return highest_; }
    /// Powers of ten; 2 and 5 of them too where the axis is shorter than three decades.
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    double from_;
    double start_;
    double to_;
    double lowest_ = 0.1;
    double highest_ = 1.0;
};

} // namespace chart
