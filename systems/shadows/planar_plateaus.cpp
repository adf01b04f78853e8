#include "systems/shadows/planar_plateaus.hpp"

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// Two directions across another, at right angles, of unit length.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& axis) {
    const glm::dvec3 other =
        std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 side = glm::normalize(glm::cross(other, axis));
    return {side, glm::cross(axis, side)};
}

/// 1 for each triangle that faces the light as its neighbours see it, one more for no triangle.
std::vector<std::uint8_t> facing(
    const CasterSurface& surface, const std::vector<glm::dvec3>& points, const LightView& light) {
    const bool sun = light.light.kind == scene::LightKind::directional;
    std::vector<std::uint8_t> faces(surface.triangle_count() + 1);
    for (std::uint32_t i = 0; i < surface.triangle_count(); ++i) {
        const glm::dvec3& a = points[surface.corners[3 * i]];
        const glm::dvec3& b = points[surface.corners[3 * i + 1]];
        const glm::dvec3& c = points[surface.corners[3 * i + 2]];
        const glm::dvec3 to_light = sun ? -glm::dvec3(light.direction) : light.position - a;
        const bool front = glm::dot(glm::cross(b - a, c - a), to_light) > 0.0;
        faces[i] = static_cast<std::uint8_t>(front != (surface.turned[i] != 0));
    }
    return faces;
}

/// Cuts what is under the plane or beyond the light off; false when nothing is left.
bool cut(const LitPlane& plane, glm::dvec3& a, glm::dvec3& b) {
    const double low = plane.least_height;
    const double high = std::min(plane.most_height(), 1e30);
    const double height_a = plane.height(a);
    const double height_b = plane.height(b);
    if (std::max(height_a, height_b) <= low || std::min(height_a, height_b) >= high) return false;
    const auto at = [&](double height) {
        return glm::mix(a, b, (height - height_a) / (height_b - height_a));
    };
    glm::dvec3 from = a;
    glm::dvec3 to = b;
    if (height_a < low) from = at(low);
    if (height_b < low) to = at(low);
    if (height_a > high) from = at(high);
    if (height_b > high) to = at(high);
    a = from;
    b = to;
    return true;
}

/// From the middle of an ellipse to where a tangent along `edge` touches it.
glm::dvec3 beside(const PenumbraEllipse& ellipse, const glm::dvec3& edge) {
    // Where the ellipse is a circle, the way there is at right angles to the edge.
    const double a = glm::dot(ellipse.radius_0, ellipse.radius_0);
    const double b = glm::dot(ellipse.radius_0, ellipse.radius_1);
    const double c = glm::dot(ellipse.radius_1, ellipse.radius_1);
    const double whole = a * c - b * b;
    if (whole <= 0.0) return {};
    const double along_0 = glm::dot(edge, ellipse.radius_0);
    const double along_1 = glm::dot(edge, ellipse.radius_1);
    const glm::dvec2 in_circle(
        (c * along_0 - b * along_1) / whole, (a * along_1 - b * along_0) / whole);
    const double length = glm::length(in_circle);
    if (length <= 0.0) return {};
    return (-in_circle.y * ellipse.radius_0 + in_circle.x * ellipse.radius_1) / length;
}

PlateauEdge
edge_on_plane(const PenumbraEllipse& a, const PenumbraEllipse& b, const glm::dvec3& origin) {
    const glm::dvec3 along = b.centre - a.centre;
    return {
        a.centre - origin,
        b.centre - origin,
        beside(a, along),
        beside(b, along),
        a.radius_0,
        a.radius_1};
}

} // namespace

PenumbraEllipse
penumbra_ellipse(const LightView& light, const LitPlane& plane, const glm::dvec3& point) {
    PenumbraEllipse ellipse;
    const double height = plane.height(point);
    const glm::dvec3& normal = plane.normal;
    if (light.light.kind == scene::LightKind::directional) {
        const glm::dvec3 towards = -glm::normalize(glm::dvec3(light.direction));
        const double sine = glm::dot(normal, towards);
        const double radius = std::tan(static_cast<double>(light.light.angular_radius));
        const auto [side, up] = across(towards);
        const auto moved = [&](const glm::dvec3& by) {
            return -height / sine * radius * (by - towards * (glm::dot(normal, by) / sine));
        };
        ellipse.centre = point - towards * (height / sine);
        ellipse.radius_0 = moved(side);
        ellipse.radius_1 = moved(up);
        return ellipse;
    }
    const double above = plane.light_height - height;
    const double growth = plane.light_height / above;
    const auto radius = static_cast<double>(light.light.radius);
    const glm::dvec3 from_light = point - light.position;
    const auto [side, up] = across(glm::normalize(-from_light));
    const auto moved = [&](const glm::dvec3& by) {
        return radius
               * (by * (1.0 - growth)
                  - from_light * (glm::dot(normal, by) * height / (above * above)));
    };
    ellipse.centre = light.position + from_light * growth;
    ellipse.radius_0 = moved(side);
    ellipse.radius_1 = moved(up);
    return ellipse;
}

std::vector<PlateauEdge> plateau_edges(
    const LightView& light,
    const LitPlane& plane,
    const CasterSurface& surface,
    std::span<const glm::vec3> positions,
    const glm::dmat4& world_from_mesh,
    const glm::dvec3& origin) {
    std::vector<glm::dvec3> points;
    points.reserve(positions.size());
    for (const glm::vec3& position : positions)
        points.emplace_back(world_from_mesh * glm::dvec4(position, 1.0));
    const std::vector<std::uint8_t> faces = facing(surface, points, light);
    const std::uint32_t none = surface.triangle_count();
    std::vector<PlateauEdge> edges;
    for (const CasterSurface::Edge& edge : surface.edges) {
        const bool border = edge.left == none || edge.right == none;
        if (!border && faces[edge.left] == faces[edge.right]) continue;
        glm::dvec3 from = points[edge.from];
        glm::dvec3 to = points[edge.to];
        if (!cut(plane, from, to)) continue;
        edges.push_back(edge_on_plane(
            penumbra_ellipse(light, plane, from), penumbra_ellipse(light, plane, to), origin));
    }
    return edges;
}

} // namespace shadows
