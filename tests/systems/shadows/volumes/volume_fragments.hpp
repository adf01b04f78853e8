// How many fragments a volume makes, by the areas of its triangles on screen: what a prediction is
// held against.

#pragma once

#include "systems/shadows/screen_bounds.hpp"
#include "systems/shadows/volumes/volume_casters.hpp"
#include "tests/systems/shadows/volumes/volume_counting.hpp"

#include <cmath>
#include <vector>

namespace shadows {

using ClipPolygon = std::vector<glm::dvec4>;

/// The part of a polygon before a plane through the origin of clip space.
/// Source: I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping", 1974.
inline ClipPolygon clipped(const ClipPolygon& polygon, const glm::dvec4& plane) {
    ClipPolygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4& a = polygon[i];
        const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
        const double at_a = glm::dot(plane, a);
        const double at_b = glm::dot(plane, b);
        if (at_a >= 0.0) left.push_back(a);
        if ((at_a >= 0.0) != (at_b >= 0.0)) left.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    return left;
}

/// Pixels of a triangle inside a box of pixels, in front of the near plane.
inline double
pixels_of(ClipPolygon polygon, const scene::CameraView& camera, const PixelBox& inside) {
    const glm::dvec2 size(camera.width, camera.height);
    const auto in_clip = [](double px, double whole) { return 2.0 * px / whole - 1.0; };
    for (const glm::dvec4& plane :
         {glm::dvec4(0.0, 0.0, -1.0, 1.0), // depth is reversed: nearer than the near plane is z > w
          glm::dvec4(1.0, 0.0, 0.0, -in_clip(inside.left, size.x)),
          glm::dvec4(-1.0, 0.0, 0.0, in_clip(inside.right, size.x)),
          glm::dvec4(0.0, 1.0, 0.0, -in_clip(inside.bottom, size.y)),
          glm::dvec4(0.0, -1.0, 0.0, in_clip(inside.top, size.y))})
        polygon = clipped(polygon, plane);
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4& a = polygon[i];
        const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
        twice += (a.x / a.w) * (b.y / b.w) - (b.x / b.w) * (a.y / a.w);
    }
    return 0.5 * std::abs(twice) * 0.25 * size.x * size.y;
}

/// Fragments of a caster's volume inside its scissor, hidden ones included, as z-pass draws it, or
/// with all caps.
inline double
fragments_of(const VolumeCaster& caster, const scene::CameraView& camera, bool with_caps) {
    const PixelBox inside = swept_pixels(camera, caster.reaches);
    if (inside.empty()) return 0.0;
    glm::dmat4 relative_from_mesh = caster.world_from_mesh;
    relative_from_mesh[3] -= glm::dvec4(camera.position, 0.0);
    const glm::dmat4 clip_from_mesh = glm::dmat4(camera.clip_from_relative()) * relative_from_mesh;
    const std::vector<std::uint32_t>& indices = caster.volume->indices;
    const std::size_t first = with_caps ? 0 : caster.volume->far_end;
    const std::size_t end = with_caps ? indices.size() : caster.volume->side_end;
    double sum = 0.0;
    for (std::size_t i = first; i < end; i += 3) {
        ClipPolygon polygon;
        for (std::size_t k = 0; k < 3; ++k)
            polygon.push_back(
                clip_from_mesh * corner_of(indices[i + k], *caster.positions, caster.light_mesh));
        sum += pixels_of(std::move(polygon), camera, inside);
    }
    return sum;
}

} // namespace shadows
