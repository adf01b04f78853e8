#include "engine/app/route_hands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

/// The tilt that axis() reads as `value`, beyond the stick's dead zone.
float tilt_for(double value) {
    constexpr double kDeadZone = 0.15;
    const double size = std::min(std::abs(value), 1.0);
    return static_cast<float>(std::copysign(kDeadZone + (1.0 - kDeadZone) * size, value));
}

} // namespace

void RouteHands::next() {
    const std::size_t last = path_.points.size() - 1;
    nearest_ = 1e9;
    waited_ = 0.0;
    if (path_.closed) {
        target_ = target_ == last ? 0 : target_ + 1;
        if (target_ == 0) ++rounds_;
        return;
    }
    if (target_ == (back_ ? 0 : last)) {
        back_ = !back_;
        ++rounds_;
    }
    target_ += back_ ? std::size_t(-1) : 1;
}

RawInput RouteHands::take(const FirstPerson& person, double seconds) {
    constexpr double kReached = 0.35; // m
    constexpr double kPatience = 2.5; // s
    constexpr double kTurnGain = 1.5; // stick per radian
    const auto way = [&] {
        const glm::dvec3 offset = path_.points[target_] - person.stance().feet;
        return glm::dvec2(offset.x, offset.z);
    };
    const double distance = glm::length(way());
    waited_ = distance < nearest_ - 0.05 ? 0.0 : waited_ + seconds;
    nearest_ = std::min(nearest_, distance);
    if (waited_ > kPatience) ++missed_;
    if (distance < kReached || waited_ > kPatience) next();

    const double wanted = std::atan2(-way().x, -way().y);
    const double turn =
        std::remainder(wanted - static_cast<double>(person.look().yaw), 2.0 * std::numbers::pi);
    ScriptedInput hands;
    hands.tilt(Axis::right_x, tilt_for(-kTurnGain * turn));
    hands.tilt(Axis::left_y, tilt_for(std::cos(std::clamp(turn, -1.5, 1.5))));
    return hands.take();
}

} // namespace app
