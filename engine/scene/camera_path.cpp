#include "engine/scene/camera_path.hpp"

#include "engine/core/check.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scene {

namespace {

glm::dvec3 spline(
    const glm::dvec3& before,
    const glm::dvec3& from,
    const glm::dvec3& to,
    const glm::dvec3& after,
    double at) {
    const glm::dvec3 linear = to - before;
    const glm::dvec3 square = 2.0 * before - 5.0 * from + 4.0 * to - after;
    const glm::dvec3 cube = -before + 3.0 * from - 3.0 * to + after;
    return from + 0.5 * at * (linear + at * (square + at * cube));
}

CameraView turning(CameraView view, double at) {
    constexpr double kReach = std::numbers::pi / 6.0;
    const auto angle = static_cast<float>(kReach * std::sin(2.0 * std::numbers::pi * at));
    view.world_from_view =
        glm::mat3_cast(glm::angleAxis(angle, glm::vec3(0.0F, 1.0F, 0.0F))) * view.world_from_view;
    return view;
}

} // namespace

CameraView view_along(const std::vector<CameraView>& stops, double at) {
    CHECK(!stops.empty());
    const double place = std::clamp(at, 0.0, 1.0);
    if (stops.size() == 1) return turning(stops.front(), place);
    const auto last = static_cast<std::ptrdiff_t>(stops.size()) - 1;
    const double scaled = place * static_cast<double>(last);
    const auto from = std::min(static_cast<std::ptrdiff_t>(scaled), last - 1);
    const auto stop = [&](std::ptrdiff_t index) -> const CameraView& {
        return stops[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last))];
    };
    const double within = scaled - static_cast<double>(from);
    CameraView view = stop(from);
    view.position = spline(
        stop(from - 1).position,
        stop(from).position,
        stop(from + 1).position,
        stop(from + 2).position,
        within);
    const auto share = static_cast<float>(within);
    view.world_from_view = glm::mat3_cast(glm::slerp(
        glm::quat_cast(stop(from).world_from_view),
        glm::quat_cast(stop(from + 1).world_from_view),
        share));
    view.fov_y = glm::mix(stop(from).fov_y, stop(from + 1).fov_y, share);
    return view;
}

} // namespace scene
