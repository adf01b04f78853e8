#include "systems/shadows/pairs.hpp"

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// A ray from the origin along `direction` meets the box (Kay and Kajiya's slabs, 1986).
bool ray_meets(const engine::WorldAabb& box, const glm::dvec3& direction) {
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (box.min[axis] > 0.0 || box.max[axis] < 0.0) return false;
            continue;
        }
        const double a = box.min[axis] / direction[axis];
        const double b = box.max[axis] / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

/// A box less a thousandth of each side, so that what stands on a floor does not count as under it.
engine::WorldAabb without_skin(const engine::WorldAabb& box) {
    const glm::dvec3 skin = box.extent() * 1e-3;
    return {box.min + skin, box.max - skin};
}

/// A convex mesh is lit wherever it faces the light, as far as it alone is concerned.
bool is_convex_self(
    const ShadowScene& scene, const CasterGroup& group, const ReceiverView& receiver) {
    if (group.casters.size() != 1) return false;
    const CasterView& caster = scene.casters[group.casters.front()];
    return caster.convex && caster.id == receiver.entity;
}

struct Ball {
    glm::dvec3 offset; ///< centre relative to the light
    double distance;
    double radius;

    Ball(const engine::WorldAabb& box, const glm::dvec3& light)
        : offset(box.centre() - light),
          distance(glm::length(offset)),
          radius(glm::length(box.extent()) * 0.5) {}

    [[nodiscard]] bool holds_light() const { return distance <= radius; }
    [[nodiscard]] double half_angle() const { return std::asin(radius / distance); }
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

bool can_shadow(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver) {
    if (light.light.kind == scene::LightKind::directional) {
        // A point of the caster moved along the light meets the receiver exactly when the ray meets
        // their difference.
        const engine::WorldAabb difference{receiver.min - caster.max, receiver.max - caster.min};
        return ray_meets(without_skin(difference), glm::dvec3(light.direction));
    }
    // A blocker lies between the light and what it darkens, along each axis.
    engine::WorldAabb between = receiver;
    between.grow(light.position - static_cast<double>(light.light.radius));
    between.grow(light.position + static_cast<double>(light.light.radius));
    if (!without_skin(between).intersects(without_skin(caster))) return false;
    const Ball blocker(caster, light.position);
    const Ball target(receiver, light.position);
    if (blocker.holds_light() || target.holds_light()) return true;
    if (target.distance + target.radius < blocker.distance - blocker.radius) return false;
    return angle_between(blocker.offset, target.offset)
           <= blocker.half_angle() + target.half_angle();
}

bool can_reach(const LightView& light, const engine::WorldAabb& box) {
    if (light.light.kind == scene::LightKind::directional) return true;
    const glm::dvec3 nearest = glm::clamp(light.position, box.min, box.max);
    if (glm::length(nearest - light.position) > static_cast<double>(light.light.range))
        return false;
    if (light.light.kind == scene::LightKind::point) return true;
    const Ball ball(box, light.position);
    return ball.holds_light()
           || angle_between(ball.offset, glm::dvec3(light.direction))
                  <= static_cast<double>(light.light.outer_angle) + ball.half_angle();
}

bool faces(const LightView& light, const ReceiverView& receiver) {
    if (!receiver.flat || receiver.two_sided) return true;
    if (light.light.kind == scene::LightKind::directional)
        return glm::dot(receiver.normal, glm::dvec3(light.direction))
               < std::sin(static_cast<double>(light.light.angular_radius));
    const double above = glm::dot(receiver.normal, light.position) - receiver.offset;
    return above > -static_cast<double>(light.light.radius) - receiver.residual;
}

bool stands_before(const engine::WorldAabb& caster, const ReceiverView& receiver) {
    if (!receiver.flat || receiver.two_sided) return true;
    // The corner farthest along the normal. Source: support point of a box.
    const double highest = glm::dot(receiver.normal, caster.centre())
                           + glm::dot(glm::abs(receiver.normal), caster.extent() * 0.5)
                           - receiver.offset;
    // A patch's own mesh touches its plane, give or take rounding.
    return highest > receiver.residual + 1e-5 * glm::length(receiver.bounds.extent());
}

std::vector<Pair>
find_pairs(const ShadowScene& scene, std::uint32_t light, const std::vector<CasterGroup>& groups) {
    const LightView& view = scene.lights[light];
    const engine::Frustum frustum = engine::frustum_from_clip(scene.camera.clip_from_relative());
    std::vector<Pair> pairs;
    for (std::uint32_t index = 0; index < scene.receivers.size(); ++index) {
        const ReceiverView& receiver = scene.receivers[index];
        if (!frustum.intersects(engine::relative_to(receiver.bounds, scene.camera.position)))
            continue;
        if (!can_reach(view, receiver.bounds) || !faces(view, receiver)) continue;
        Pair pair{light, index, {}};
        for (std::uint32_t group = 0; group < groups.size(); ++group)
            if (!is_convex_self(scene, groups[group], receiver)
                && stands_before(groups[group].bounds, receiver)
                && can_shadow(view, groups[group].bounds, receiver.bounds))
                pair.groups.push_back(group);
        if (!pair.groups.empty()) pairs.push_back(std::move(pair));
    }
    return pairs;
}

} // namespace shadows
