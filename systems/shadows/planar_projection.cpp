#include "systems/shadows/planar_projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadows {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Rounding of a position in 32 bits, relative to its distance from the origin, through a matrix.
constexpr double kPositionError = 1e-6;
/// The part of the light's height that is left out below the light: shadows of what lies there are
/// a thousand times as far away as the light is high.
constexpr double kUnderLight = 1e-3;

bool is_sun(const LightView& light) {
    return light.light.kind == scene::LightKind::directional;
}

/// The light as a homogeneous point: along a sun's rays, in units that make its height 1.
glm::dvec4 light_point(const LightView& light, const LitPlane& plane, const glm::dvec3& origin) {
    if (is_sun(light)) {
        const glm::dvec3 towards = -glm::dvec3(light.direction);
        return glm::dvec4(towards / glm::dot(plane.normal, towards), 0.0);
    }
    return glm::dvec4(light.position - origin, 1.0) / plane.height(light.position);
}

double farthest_corner(const engine::WorldAabb& box, const glm::dvec3& point) {
    return glm::length(glm::max(glm::abs(box.min - point), glm::abs(box.max - point)));
}

} // namespace

double LitPlane::most_height() const {
    return light_height * (1.0 - kUnderLight);
}

std::optional<LitPlane>
lit_plane(const LightView& light, const ReceiverView& receiver, const glm::dvec3& origin) {
    LitPlane plane{receiver.normal, receiver.offset};
    plane.least_height =
        2.0 * receiver.residual + kPositionError * farthest_corner(receiver.bounds, origin);
    const auto height_of_light = [&] {
        return is_sun(light) ? -glm::dot(plane.normal, glm::dvec3(light.direction))
                             : plane.height(light.position);
    };
    if (receiver.two_sided && height_of_light() < 0.0) {
        plane.normal = -plane.normal;
        plane.offset = -plane.offset;
    }
    if (height_of_light() <= (is_sun(light) ? 0.0 : plane.least_height)) return std::nullopt;
    plane.light_height = is_sun(light) ? kInfinite : height_of_light();
    return plane;
}

glm::dmat4
shadow_from_caster(const LightView& light, const LitPlane& plane, const glm::dvec3& origin) {
    const glm::dvec4 heights(plane.normal, glm::dot(plane.normal, origin) - plane.offset);
    return glm::dmat4(1.0) - glm::outerProduct(light_point(light, plane, origin), heights);
}

engine::WorldAabb shadow_bounds(
    const LightView& light,
    const LitPlane& plane,
    const ReceiverView& receiver,
    const engine::WorldAabb& caster) {
    const glm::dvec3 origin = caster.centre();
    const glm::dmat4 project = shadow_from_caster(light, plane, origin);
    engine::WorldAabb shadow;
    bool under_plane = false;
    bool over_plane = false;
    bool beyond_light = false;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner = caster.corner(i);
        const double height = plane.height(corner);
        under_plane = under_plane || height < plane.least_height;
        over_plane = over_plane || height > plane.least_height;
        beyond_light = beyond_light || height > plane.most_height();
        if (height < plane.least_height || height > plane.most_height()) continue;
        const glm::dvec4 point = project * glm::dvec4(corner - origin, 1.0);
        shadow.grow(origin + glm::dvec3(point) / point.w);
    }
    if (!over_plane || (beyond_light && shadow.empty() && !under_plane)) return {};
    // Where the box meets the plane it is its own shadow; where it meets the light's height the
    // shadow has no end.
    if (under_plane) shadow.grow(caster);
    if (beyond_light) shadow = receiver.bounds;
    const double margin = plane.least_height;
    shadow.min = glm::max(shadow.min - margin, receiver.bounds.min - margin);
    shadow.max = glm::min(shadow.max + margin, receiver.bounds.max + margin);
    return shadow.empty() ? engine::WorldAabb{} : shadow;
}

double sine_of_elevation(const LightView& light, const LitPlane& plane, const glm::dvec3& point) {
    const glm::dvec3 towards =
        is_sun(light) ? -glm::dvec3(light.direction) : glm::normalize(light.position - point);
    return glm::dot(plane.normal, towards);
}

} // namespace shadows
