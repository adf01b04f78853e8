#include "engine/scene/light.hpp"

#include <algorithm>
#include <cmath>

namespace scene {

namespace {

/// Nearer than a centimetre the inverse square law stops: a point on the light itself stays finite.
constexpr float kMinSquaredDistance = 1e-4F;

float range_window(float distance, float range) {
    const float ratio = distance / range;
    return std::clamp(1.0F - ratio * ratio * ratio * ratio, 0.0F, 1.0F);
}

float cone(const Light& light, float cos_angle) {
    /// Keeps the division finite where the inner angle meets the outer one (value of the
    /// extension's text).
    constexpr float kMinCosineSpan = 0.001F;
    const float cos_outer = std::cos(light.outer_angle);
    const float span = std::max(kMinCosineSpan, std::cos(light.inner_angle) - cos_outer);
    const float linear = std::clamp((cos_angle - cos_outer) / span, 0.0F, 1.0F);
    return linear * linear;
}

} // namespace

float illuminance_at(const PlacedLight& light, const glm::vec3& to_light) {
    const Light& source = light.light;
    if (source.kind == LightKind::directional) return source.intensity;

    const float squared_distance = glm::dot(to_light, to_light);
    const float distance = std::sqrt(squared_distance);
    const float falloff =
        range_window(distance, source.range) / std::max(squared_distance, kMinSquaredDistance);
    if (source.kind == LightKind::point) return source.intensity * falloff;

    const float cos_angle =
        distance > 0.0F ? -glm::dot(to_light, light.direction) / distance : 1.0F;
    return source.intensity * falloff * cone(source, cos_angle);
}

} // namespace scene
