// Where a box of the world lies on screen: the pixels that a pass has to touch at most.

#pragma once

#include "engine/core/geometry.hpp"
#include "engine/scene/camera.hpp"

#include <cstddef>
#include <span>

namespace shadows {

/// Pixels [left, right) x [bottom, top), origin bottom left, inside the picture.
struct PixelBox {
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;

    [[nodiscard]] bool empty() const { return left >= right || bottom >= top; }
    [[nodiscard]] double area() const {
        return empty() ? 0.0
                       : static_cast<double>(right - left) * static_cast<double>(top - bottom);
    }
    bool operator==(const PixelBox&) const = default;
};

inline constexpr std::size_t kMostHullPoints = 16;

/// The pixels whose centres can show a point of the convex hull of some points: the lines between
/// them, cut at the near plane, and rounded outward. Empty when nothing of it is in view.
/// @pre at most kMostHullPoints
/// Cost: one line for every two points on different sides of the near plane.
PixelBox hull_bounds(const scene::CameraView& camera, std::span<const glm::dvec3> points);
/// The same for a box; empty when the box is.
PixelBox screen_bounds(const scene::CameraView& camera, const engine::WorldAabb& box);

/// The size of a pixel where a box is nearest to the camera, metres.
double pixel_size_at(const scene::CameraView& camera, const engine::WorldAabb& box);

/// How far away most of what is seen of a box is, metres: the geometric mean of its nearest point
/// and its centre. A camera inside the box, or on a floor, sees little of what is at its feet.
double typical_distance(const scene::CameraView& camera, const engine::WorldAabb& box);

} // namespace shadows
