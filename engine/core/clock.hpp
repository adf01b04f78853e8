// Simulated time in fixed steps, so that the same inputs give the same run on every machine.

#pragma once

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace engine {

/// Turns elapsed time into whole steps and keeps the rest for the next frame.
class FixedClock {
public:
    /// @param step      seconds; 1/60 unless the game says otherwise
    /// @param max_steps per call of advance(): time beyond is dropped, so that a slow frame slows
    /// the game
    ///                  down instead of making the next frame slower still
    explicit FixedClock(double step = 1.0 / 60.0, int max_steps = 8)
        : step_(step),
          max_steps_(max_steps) {
        CHECK_GT(step, 0.0);
        CHECK_GT(max_steps, 0);
    }

    /// @param elapsed seconds since the last call, at least 0
    /// @return how many steps to simulate now
    int advance(double elapsed) {
        CHECK(elapsed >= 0.0);
        rest_ += elapsed;
        const double due = std::floor(rest_ / step_);
        if (due > max_steps_) {
            rest_ = 0.0;
            step_count_ += static_cast<std::uint64_t>(max_steps_);
            return max_steps_;
        }
        rest_ = std::max(0.0, rest_ - due * step_);
        step_count_ += static_cast<std::uint64_t>(due);
        return static_cast<int>(due);
    }

    [[nodiscard]] double step() const { return step_; }
    /// Simulated seconds: a whole number of steps, without the drift of a running sum.
    [[nodiscard]] double time() const { return static_cast<double>(step_count_) * step_; }
    [[nodiscard]] std::uint64_t step_count() const { return step_count_; }
    /// How far real time is into the next step, in [0, 1): for drawing between two steps.
    [[nodiscard]] double fraction() const { return std::min(rest_ / step_, 1.0 - 0x1p-30); }

private:
    double step_;
    int max_steps_;
    double rest_ = 0.0;
    std::uint64_t step_count_ = 0;
};

} // namespace engine
