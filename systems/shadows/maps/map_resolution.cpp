#include "systems/shadows/maps/map_resolution.hpp"

#include <cmath>

namespace shadows {

namespace {

// Of include/map_place.glsl: ROUNDING_TEXELS and CREASE_TANGENT.
constexpr double kRoundingTexels = 0.25;
constexpr double kCreaseTangent = 2.0;

/// Rows of a view's rotation.
struct Axes {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;

    explicit Axes(const glm::dmat3& light_from_world) {
        const glm::dmat3 rows = glm::transpose(light_from_world);
        right = rows[0];
        up = rows[1];
        forward = rows[2];
    }
};

/// @param texel metres across the light
TexelOnSurface thrown(
    const Axes& axes,
    const glm::dvec2& texel,
    const glm::dvec3& ray,
    const glm::dvec3& normal,
    double reach) {
    const auto along_plane = [&](const glm::dvec3& across, double length) {
        return length * (across - ray * (glm::dot(normal, across) / glm::dot(normal, ray)));
    };
    TexelOnSurface result;
    result.right = along_plane(axes.right, texel.x);
    result.up = along_plane(axes.up, texel.y);
    result.ray = ray;
    const double slope = std::abs(glm::dot(result.right, axes.forward))
                         + std::abs(glm::dot(result.up, axes.forward));
    const double largest = std::max(texel.x, texel.y);
    result.depth_unknown = kRoundingTexels * (largest + slope) + kCreaseTangent * reach * largest;
    return result;
}

/// What a step in the world is on screen, pixels.
glm::dvec2
pixels_of(const scene::CameraView& camera, const glm::dvec3& point, const glm::dvec3& step) {
    const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(camera.world_from_view));
    const glm::dvec3 point_vs = view_from_world * (point - camera.position);
    const glm::dvec3 step_vs = view_from_world * step;
    const double depth = -point_vs.z;
    return (glm::dvec2(step_vs) + glm::dvec2(point_vs) * (step_vs.z / depth))
           / (depth * camera.pixel_size());
}

/// Of the matrix with these columns.
double larger_singular_value(const glm::dvec2& a, const glm::dvec2& b) {
    const double squares = glm::dot(a, a) + glm::dot(b, b);
    const double area = a.x * b.y - a.y * b.x;
    const double root = std::sqrt(std::max(squares * squares - 4.0 * area * area, 0.0));
    return std::sqrt(0.5 * (squares + root));
}

} // namespace

TexelOnSurface texel_at(const ParallelView& view, const SurfacePoint& point, double reach) {
    const Axes axes(view.light_from_world);
    return thrown(axes, view.texel, axes.forward, point.normal, reach);
}

TexelOnSurface texel_at(const PyramidView& view, const SurfacePoint& point, double reach) {
    const Axes axes(view.light_from_world);
    const glm::dvec3 offset = point.position - view.position;
    const double distance = glm::dot(axes.forward, offset);
    const glm::dvec2 texel = (view.max - view.min) / static_cast<double>(view.size) * distance;
    return thrown(axes, texel, offset / distance, point.normal, reach);
}

Resolution
on_screen(const scene::CameraView& camera, const SurfacePoint& point, const TexelOnSurface& texel) {
    const glm::dvec3 raised = -texel.ray * texel.depth_unknown;
    const glm::dvec3 shift = raised - point.normal * glm::dot(raised, point.normal);
    return {
        larger_singular_value(
            pixels_of(camera, point.position, texel.right),
            pixels_of(camera, point.position, texel.up)),
        glm::length(pixels_of(camera, point.position, shift))};
}

} // namespace shadows
