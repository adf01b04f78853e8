#include "systems/shadows/volumes/swept_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadows {

namespace {

/// The steps at which a moving box meets another one.
struct Steps {
    double first;
    double last = std::numeric_limits<double>::infinity();

    /// Keeps those at which rate * step + offset <= 0.
    void hold(double rate, double offset) {
        if (rate > 0.0)
            last = std::min(last, -offset / rate);
        else if (rate < 0.0)
            first = std::max(first, -offset / rate);
        else if (offset > 0.0)
            last = -std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] bool none() const { return first > last; }
};

/// A corner of the caster at a step: a sun moves it along its way, a lamp away from itself.
glm::dvec3 moved(const LightView& light, const glm::dvec3& point, double step) {
    if (light.light.kind == scene::LightKind::directional)
        return point + glm::dvec3(light.direction) * step;
    return light.position + (point - light.position) * step;
}

Steps meeting_steps(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver) {
    const bool sun = light.light.kind == scene::LightKind::directional;
    Steps steps{sun ? 0.0 : 1.0};
    for (int axis = 0; axis < 3; ++axis) {
        if (sun) {
            const auto rate = static_cast<double>(light.direction[axis]);
            steps.hold(rate, caster.min[axis] - receiver.max[axis]);
            steps.hold(-rate, receiver.min[axis] - caster.max[axis]);
        } else {
            const double at = light.position[axis];
            steps.hold(caster.min[axis] - at, at - receiver.max[axis]);
            steps.hold(at - caster.max[axis], receiver.min[axis] - at);
        }
    }
    return steps;
}

} // namespace

std::optional<SweptReach> swept_reach(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver) {
    Steps steps = meeting_steps(light, caster, receiver);
    if (steps.none()) return std::nullopt;
    if (!std::isfinite(steps.last)) {
        // The light is in the caster's box: its shadow goes everywhere.
        SweptReach everywhere{receiver, {}};
        for (int i = 0; i < 16; ++i)
            everywhere.corners[static_cast<std::size_t>(i)] = receiver.corner(i % 8);
        return everywhere;
    }
    SweptReach reach;
    engine::WorldAabb swept;
    for (int i = 0; i < 16; ++i) {
        const glm::dvec3 corner =
            moved(light, caster.corner(i % 8), i < 8 ? steps.first : steps.last);
        reach.corners[static_cast<std::size_t>(i)] = corner;
        swept.grow(corner);
    }
    reach.bounds = {glm::max(swept.min, receiver.min), glm::min(swept.max, receiver.max)};
    // Rounding may part what only touches.
    reach.bounds.max = glm::max(reach.bounds.min, reach.bounds.max);
    return reach;
}

PixelBox swept_pixels(const scene::CameraView& camera, const std::vector<SweptReach>& reaches) {
    PixelBox all;
    for (const SweptReach& reach : reaches) {
        const PixelBox box = screen_bounds(camera, reach.bounds);
        const PixelBox hull = hull_bounds(camera, reach.corners);
        const PixelBox both{
            std::max(box.left, hull.left),
            std::max(box.bottom, hull.bottom),
            std::min(box.right, hull.right),
            std::min(box.top, hull.top)};
        if (both.empty()) continue;
        if (all.empty())
            all = both;
        else
            all = {
                std::min(all.left, both.left),
                std::min(all.bottom, both.bottom),
                std::max(all.right, both.right),
                std::max(all.top, both.top)};
    }
    return all;
}

} // namespace shadows
