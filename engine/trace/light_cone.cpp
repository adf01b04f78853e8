#include "engine/trace/light_cone.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace trace {

LightCone::LightCone(const scene::PlacedLight& light, const glm::dvec3& point) {
    if (light.light.kind == scene::LightKind::directional) {
        axis_ = -glm::normalize(glm::dvec3(light.direction));
        centre_distance_ = std::numeric_limits<double>::infinity();
        cos_half_angle_ = std::cos(static_cast<double>(light.light.angular_radius));
    } else {
        const glm::dvec3 to_light = light.position - point;
        centre_distance_ = glm::length(to_light);
        axis_ = centre_distance_ > 0.0 ? to_light / centre_distance_ : glm::dvec3(0.0, 1.0, 0.0);
        radius_ = static_cast<double>(light.light.radius);
        if (radius_ > 0.0) {
            const double sine = radius_ / std::max(radius_, centre_distance_);
            cos_half_angle_ = std::sqrt(1.0 - sine * sine);
        }
    }
    const glm::dvec3 other = std::abs(axis_.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    side_ = glm::normalize(glm::cross(other, axis_));
    up_ = glm::cross(axis_, side_);
}

glm::dvec3 LightCone::direction(const glm::dvec2& square) const {
    // Height on the unit sphere is uniform in solid angle (Archimedes). The sine comes from 1 -
    // cosine, which keeps its digits for lights as small as the sun.
    const double below_pole = square.x * (1.0 - cos_half_angle_);
    const double sine = std::sqrt(below_pole * (2.0 - below_pole));
    const double turn = glm::two_pi<double>() * square.y;
    return (1.0 - below_pole) * axis_ + sine * (std::cos(turn) * side_ + std::sin(turn) * up_);
}

double LightCone::distance(const glm::dvec3& direction) const {
    if (std::isinf(centre_distance_)) return centre_distance_;
    const double along = glm::dot(direction, axis_) * centre_distance_;
    const double across_squared = centre_distance_ * centre_distance_ - along * along;
    const double inside = std::sqrt(std::max(0.0, radius_ * radius_ - across_squared));
    return std::max(0.0, along - inside) * (1.0 - 1e-9);
}

} // namespace trace
