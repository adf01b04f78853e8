// A case all the way through its sweep, with its remedy and without, and what is to be said of it.

#pragma once

#include "engine/core/image.hpp"
#include "tests/atlas/atlas.hpp"

#include <functional>
#include <string>
#include <vector>

namespace atlas {

/// The values that a sweep is run at: evenly spread, ascending, with the worst in the place of the
/// nearest one. @pre count > 1
std::vector<double> steps_of(const Sweep& sweep, int count);

/// One gate's figure along the sweep.
struct Curve {
    std::string figure;
    double at_most = 0.0;
    std::vector<double> off; ///< without the remedy, one value per step; empty when there is none
    std::vector<double> on;  ///< with everything on
};

/// What a case showed.
struct Outcome {
    std::string id;
    std::string sentence;
    std::string remedy;        ///< its spelling; empty when the technique's nature is the remedy
    std::vector<double> steps; ///< of the parameter, ascending
    std::size_t worst = 0;     ///< index of the step where the failure shows most
    std::vector<Curve> curves; ///< one per gate
    std::string problem;       ///< why it could not be run; empty when it could
    engine::Image without;     ///< masks at the worst step; empty when there is no remedy
    engine::Image with;
    engine::Image truth;

    /// Fails at the worst step without its remedy.
    [[nodiscard]] bool fails_without() const;
    /// Keeps every gate at every step with it.
    [[nodiscard]] bool holds() const;
    /// Holds, and fails without its remedy where it has one.
    [[nodiscard]] bool good() const;
    /// "holds", or what is wrong.
    [[nodiscard]] std::string verdict() const;
    /// The gate that tells most: the one farthest over its limit anywhere.
    [[nodiscard]] const Curve& telling() const;
};

/// The largest value of a curve's half; 0 of an empty one.
double largest(const std::vector<double>& values);

/// Runs a case. What fails ends up in Outcome::problem.
/// @param done called after each step
/// Cost: a truth and two pictures a step.
Outcome run_sweep(
    const Case& one, int step_count, const std::function<void()>& done = [] {});

} // namespace atlas
