// A figure: a number, or the reason why there is none.

#pragma once

#include "engine/core/check.hpp"

#include <optional>
#include <string>
#include <utility>

namespace measure {

/// One measured number. A figure that could not be computed says why, so that a table never shows a
/// zero that nobody measured.
class Figure {
public:
    Figure() = default;
    Figure(double value) : value_(value) {}
    static Figure missing(std::string reason) {
        Figure figure;
        figure.reason_ = std::move(reason);
        return figure;
    }

    [[nodiscard]] bool known() const { return value_.has_value(); }
    /// @pre known()
    [[nodiscard]] double value() const {
        CHECK(value_.has_value());
        return *value_;
    }
    /// Why there is no value; empty when there is one.
    [[nodiscard]] std::string reason() const { return known() ? std::string() : reason_; }

private:
    std::optional<double> value_;
    std::string reason_ = "not measured";
};

} // namespace measure
