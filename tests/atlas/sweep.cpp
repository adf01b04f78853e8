#include "tests/atlas/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace atlas {

namespace {

bool over(double value, const Curve& curve) {
    return !(value <= curve.at_most);
}

/// How far over its limit a curve goes, in limits; a limit of 0 counts as 1.
double excess(const Curve& curve) {
    const double unit = std::max(curve.at_most, 1.0);
    return std::max(largest(curve.off), largest(curve.on)) / unit - curve.at_most / unit;
}

/// One step of a sweep into the outcome. Errors: what observe() says.
engine::Result<void> run_step(const Case& one, std::size_t step, Outcome& outcome) {
    Stage stage = one.build(outcome.steps[step]);
    const auto truth = trace(stage);
    if (!truth) return truth.error();
    const bool worst = step == outcome.worst;
    const std::string stem =
        worst ? one.id : fmt::format("{}_at_{:g}", one.id, outcome.steps[step]);
    const auto on = observe(stage, *truth, {}, stem);
    if (!on) return on.error();
    for (std::size_t gate = 0; gate < one.gates.size(); ++gate)
        outcome.curves[gate].on.push_back(one.gates[gate].value(*on));
    if (worst) {
        outcome.with = grey(on->comparison.measured);
        outcome.truth = grey(on->comparison.truth);
    }
    if (!one.remedy) return {};
    // A stage of its own: what was drawn with the remedy must not linger.
    Stage again = one.build(outcome.steps[step]);
    const auto off =
        observe(again, *truth, shadows::Remedies().without(*one.remedy), stem + "_without");
    if (!off) return off.error();
    for (std::size_t gate = 0; gate < one.gates.size(); ++gate)
        outcome.curves[gate].off.push_back(one.gates[gate].value(*off));
    if (worst) outcome.without = grey(off->comparison.measured);
    return {};
}

} // namespace

std::vector<double> steps_of(const Sweep& sweep, int count) {
    std::vector<double> steps;
    for (int i = 0; i < count; ++i)
        steps.push_back(sweep.from + (sweep.to - sweep.from) * i / (count - 1.0));
    *std::min_element(steps.begin(), steps.end(), [&](double a, double b) {
        return std::abs(a - sweep.worst) < std::abs(b - sweep.worst);
    }) = sweep.worst;
    std::sort(steps.begin(), steps.end());
    return steps;
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

bool Outcome::fails_without() const {
    return std::any_of(curves.begin(), curves.end(), [&](const Curve& curve) {
        return worst < curve.off.size() && over(curve.off[worst], curve);
    });
}

bool Outcome::holds() const {
    return problem.empty() && std::all_of(curves.begin(), curves.end(), [](const Curve& curve) {
               return std::none_of(curve.on.begin(), curve.on.end(), [&](double value) {
                   return over(value, curve);
               });
           });
}

bool Outcome::good() const {
    return holds() && (remedy.empty() || fails_without());
}

std::string Outcome::verdict() const {
    if (!problem.empty()) return "could not be run: " + problem;
    if (!holds()) return "broken with the remedy on";
    if (!remedy.empty() && !fails_without()) return "nothing fails with the remedy off";
    return "holds";
}

const Curve& Outcome::telling() const {
    return *std::max_element(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
        return excess(a) < excess(b);
    });
}

Outcome run_sweep(const Case& one, int step_count, const std::function<void()>& done) {
    Outcome outcome;
    outcome.id = one.id;
    outcome.sentence = one.sentence;
    if (one.remedy) outcome.remedy = shadows::name_of(*one.remedy);
    outcome.steps = steps_of(one.sweep, step_count);
    const auto worst = std::find(outcome.steps.begin(), outcome.steps.end(), one.sweep.worst);
    outcome.worst = static_cast<std::size_t>(worst - outcome.steps.begin());
    for (const Gate& gate : one.gates)
        outcome.curves.push_back({gate.figure, gate.at_most, {}, {}});
    for (std::size_t step = 0; step < outcome.steps.size(); ++step) {
        if (auto ran = run_step(one, step, outcome); !ran) {
            outcome.problem =
                fmt::format("at {:g}: {}", outcome.steps[step], engine::to_string(ran.error()));
            break;
        }
        done();
    }
    return outcome;
}

} // namespace atlas
