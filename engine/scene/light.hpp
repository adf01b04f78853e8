// Lights as components (in the space of their entity) and as placed in the world.

#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <string>

namespace scene {

enum class LightKind : std::uint8_t { directional, spot, point };

/// A light shines along the -Z axis of its entity (as in KHR_lights_punctual).
struct Light {
    LightKind kind = LightKind::directional;
    glm::vec3 color = {1.0F, 1.0F, 1.0F}; ///< linear, multiplies intensity
    float intensity =
        1.0F; ///< illuminance in lux for directional lights, candela for spot and point lights
    float range = std::numeric_limits<float>::infinity(); ///< metres; no light beyond. Directional
                                                          ///< lights ignore it
    float inner_angle = 0.0F;      ///< spot: half-angle, radians, where the fall-off begins
    float outer_angle = 0.785398F; ///< spot: half-angle, radians, where the light ends; < pi / 2
    float radius =
        0.0F; ///< spot and point: radius of the shining sphere, metres; 0 gives hard shadows
    float angular_radius = 0.0F; ///< directional: half the angle under which the light is seen,
                                 ///< radians; 0 gives hard shadows
    bool casts_shadow = true;
    bool on = true;

    bool operator==(const Light&) const = default;
};

/// One light of a frame: plain values, world space.
struct PlacedLight {
    std::string name;
    std::uint32_t id = 0; ///< entity value; stable from frame to frame
    Light light;
    glm::dvec3 position = {};                  ///< unused for directional lights
    glm::vec3 direction = {0.0F, -1.0F, 0.0F}; ///< unit; the way the light travels

    bool operator==(const PlacedLight&) const = default;
};

/// Luminous intensity over squared distance, the window that ends it at its range and the cone,
/// without N.L.
/// @param to_light from the receiver to the light, metres (ignored for directional lights)
/// @return illuminance per unit of color, lux
/// Source: KHR_lights_punctual, "Range Property" and "Inner and Outer Cone Angles".
float illuminance_at(const PlacedLight& light, const glm::vec3& to_light);

} // namespace scene
