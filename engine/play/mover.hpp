// How a body walks: it slides along walls, climbs low steps, and falls where there is no ground.
//
// The body is an upright cylinder that begins a step's height over its feet. Nothing ever enters
// it: sideways it is swept as a disc against the plan of what lies between its two ends, upwards it
// wants headroom, and downwards it stops at whatever it would enter. Its feet stand on the highest
// ground under its axis. So what is lower than a step is climbed, a slope is walked while it rises
// less than a step over the radius, and nothing is tunnelled through however long a frame takes.

#pragma once

#include "engine/play/obstacles.hpp"

#include <glm/glm.hpp>

namespace play {

/// Metres.
struct Body {
    double radius = 0.3;
    double height = 1.8;
    double eye_height = 1.7; ///< over the feet
    double step = 0.35;      ///< what is lower is climbed
};

/// Where a body is, and what it keeps from one move to the next.
struct Stance {
    glm::dvec3 feet = {};
    double fall_speed = 0.0; ///< m/s, downwards
    bool grounded = false;
    double eye_lag = 0.0; ///< what the eye still has to follow of the last steps, m

    [[nodiscard]] glm::dvec3 eye(const Body& body) const {
        return feet + glm::dvec3(0.0, body.eye_height + eye_lag, 0.0);
    }
};

/// The stance after `seconds` of walking. Pure: the same arguments give the same answer.
/// @param velocity in plan (x, z), m/s
/// A body that starts inside of something can only leave it.
Stance moved(
    const Obstacles& obstacles,
    const Body& body,
    const Stance& stance,
    const glm::dvec2& velocity,
    double seconds);

} // namespace play
