#include "engine/scene/path.hpp"

#include "engine/core/check.hpp"
#include "engine/scene/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scene {

namespace {

constexpr double kTurnReach = 0.4; // m

/// One straight piece of a path, as something goes over it.
struct Leg {
    glm::dvec3 from = {};
    glm::dvec3 to = {};
    double length = 0.0;
};

/// Every leg of a whole period that has a length.
std::vector<Leg> legs_of(const Path& path) {
    std::vector<glm::dvec3> stops = path.points;
    if (path.closed) {
        stops.push_back(stops.front());
    } else {
        stops.insert(stops.end(), path.points.rbegin() + 1, path.points.rend());
    }
    std::vector<Leg> legs;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double length = glm::length(stops[i + 1] - stops[i]);
        if (length > 0.0) legs.push_back({stops[i], stops[i + 1], length});
    }
    return legs;
}

double heading_of(const Leg& leg) {
    return std::atan2(leg.to.x - leg.from.x, leg.to.z - leg.from.z);
}

/// The shorter way from one heading to another, a share of it.
double turned(double from, double to, double share) {
    const double turn = std::remainder(to - from, 2.0 * std::numbers::pi);
    return from + share * turn;
}

double reach(const Leg& leg) {
    return std::min(kTurnReach, 0.5 * leg.length);
}

/// Half of the turn at either end of a leg is made on it.
double heading_on(const Leg& before, const Leg& leg, const Leg& after, double along) {
    const double own = heading_of(leg);
    const double to_end = leg.length - along;
    if (along < reach(leg)) return turned(heading_of(before), own, 0.5 + 0.5 * along / reach(leg));
    if (to_end < reach(leg)) return turned(own, heading_of(after), 0.5 - 0.5 * to_end / reach(leg));
    return own;
}

} // namespace

double period(const Path& path) {
    double sum = 0.0;
    for (const Leg& leg : legs_of(path))
        sum += leg.length;
    return sum;
}

PathPlace place_on(const Path& path, double travelled) {
    const std::vector<Leg> legs = legs_of(path);
    CHECK(!legs.empty());
    const double whole = period(path);
    double along = travelled - whole * std::floor(travelled / whole);
    std::size_t i = 0;
    while (i + 1 < legs.size() && along > legs[i].length)
        along -= legs[i++].length;
    const Leg& leg = legs[i];
    along = std::min(along, leg.length);
    const Leg& before = legs[(i + legs.size() - 1) % legs.size()];
    const Leg& after = legs[(i + 1) % legs.size()];
    return {
        leg.from + along / leg.length * (leg.to - leg.from), heading_on(before, leg, after, along)};
}

void advance_paths(World& world, float dt) {
    ecs::Registry& registry = world.registry;
    for (const ecs::Entity entity : registry.view<PathFollower, Transform>()) {
        const auto& follower = registry.get<PathFollower>(entity);
        const Path& path = world.assets.paths[follower.path];
        const double whole = period(path);
        const double way =
            follower.travelled + static_cast<double>(follower.speed) * static_cast<double>(dt);
        const double travelled = way - whole * std::floor(way / whole);
        if (travelled != follower.travelled)
            registry.patch<PathFollower>(
                entity, [&](PathFollower& changed) { changed.travelled = travelled; });
        const PathPlace place = place_on(path, travelled);
        const double backwards =
            registry.get<PathFollower>(entity).speed < 0.0F ? std::numbers::pi : 0.0;
        const glm::quat rotation(
            glm::angleAxis(place.heading + backwards, glm::dvec3(0.0, 1.0, 0.0)));
        const auto& now = registry.get<Transform>(entity);
        if (now.position == place.position && now.rotation == rotation) continue;
        registry.patch<Transform>(entity, [&](Transform& transform) {
            transform.position = place.position;
            transform.rotation = rotation;
        });
    }
}

} // namespace scene
