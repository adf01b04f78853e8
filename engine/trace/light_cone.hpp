// A light as one point sees it: the directions that lead to it, and how far it is along each of
// them.

#pragma once

#include "engine/scene/light.hpp"

#include <glm/glm.hpp>

namespace trace {

/// The directions within `half_angle` of `axis`: to a shining sphere, or to a sun. A light without
/// a size has a half_angle of 0.
class LightCone {
public:
    LightCone(const scene::PlacedLight& light, const glm::dvec3& point);

    /// Unit length, towards the centre of the light.
    [[nodiscard]] const glm::dvec3& axis() const { return axis_; }
    [[nodiscard]] bool hard() const { return cos_half_angle_ == 1.0; }

    /// A direction of unit length, uniform in solid angle for a uniform point of the unit square.
    [[nodiscard]] glm::dvec3 direction(const glm::dvec2& square) const;
    /// Metres to the light's surface along a direction of the cone, less a hair; infinite for
    /// directional lights.
    [[nodiscard]] double distance(const glm::dvec3& direction) const;

private:
    glm::dvec3 axis_ = {};
    glm::dvec3 side_ = {}; ///< with axis_ and up_ an orthonormal frame
    glm::dvec3 up_ = {};
    double cos_half_angle_ = 1.0;
    double centre_distance_ = 0.0;
    double radius_ = 0.0;
};

} // namespace trace
