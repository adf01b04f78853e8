// Cameras: infinite reversed-depth perspective, and the rays through its pixels.

#pragma once

#include <glm/glm.hpp>

#include <string>

namespace scene {

/// Component: looks along the -Z axis of its entity.
struct Camera {
    float fov_y = 1.0471976F; ///< full vertical angle, radians
    float near = 0.1F;        ///< metres; there is no far plane
};

/// One camera of a frame, with the size of its picture.
struct CameraView {
    std::string name;
    glm::dvec3 position = {};
    glm::mat3 world_from_view = glm::mat3(1.0F); ///< rotation only; columns are right, up, back
    float fov_y = 1.0471976F;
    float near = 0.1F;
    int width = 1280;
    int height = 720;

    bool operator==(const CameraView&) const = default;

    [[nodiscard]] double aspect() const { return static_cast<double>(width) / height; }

    /// Reversed infinite projection: z_clip = near, w_clip = -z_view, so depth is near / distance.
    /// Source: Upchurch and Desbrun, "Tightening the Precision of Perspective Rendering", 2012.
    [[nodiscard]] glm::mat4 clip_from_view() const;
    /// The world relative to the camera's position (same axes as the world) to view space.
    [[nodiscard]] glm::mat4 view_from_relative() const;
    [[nodiscard]] glm::mat4 clip_from_relative() const {
        return clip_from_view() * view_from_relative();
    }

    /// Direction in world space, not normalised, of length 1 along the view axis: a hit at
    /// parameter t has view depth t.
    /// @param x_px, y_px picture coordinates, origin top left; the centre of the first pixel is
    /// (0.5, 0.5)
    [[nodiscard]] glm::dvec3 ray_direction(double x_px, double y_px) const;

    /// Size of a pixel at view depth 1, in metres: p(z) = 2 z tan(fov_y / 2) / height.
    [[nodiscard]] double pixel_size() const;

    /// Picture coordinates (origin top left, pixels) and view depth of a world point.
    /// z <= 0 means behind the camera; x and y are then meaningless.
    [[nodiscard]] glm::dvec3 project(const glm::dvec3& point) const;
};

} // namespace scene
