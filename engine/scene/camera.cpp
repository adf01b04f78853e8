#include "engine/scene/camera.hpp"

#include <cmath>

namespace scene {

glm::mat4 CameraView::clip_from_view() const {
    const double focal = 1.0 / std::tan(static_cast<double>(fov_y) * 0.5);
    glm::mat4 clip(0.0F);
    clip[0][0] = static_cast<float>(focal / aspect());
    clip[1][1] = static_cast<float>(focal);
    clip[2][3] = -1.0F;
    clip[3][2] = near;
    return clip;
}

glm::mat4 CameraView::view_from_relative() const {
    return glm::mat4(glm::transpose(world_from_view));
}

glm::dvec3 CameraView::ray_direction(double x_px, double y_px) const {
    const double half_height = std::tan(static_cast<double>(fov_y) * 0.5);
    const glm::dvec3 direction_vs(
        (2.0 * x_px / width - 1.0) * half_height * aspect(),
        (1.0 - 2.0 * y_px / height) * half_height,
        -1.0);
    return glm::dmat3(world_from_view) * direction_vs;
}

double CameraView::pixel_size() const {
    return 2.0 * std::tan(static_cast<double>(fov_y) * 0.5) / height;
}

glm::dvec3 CameraView::project(const glm::dvec3& point) const {
    const glm::dvec3 point_vs = glm::transpose(glm::dmat3(world_from_view)) * (point - position);
    const double depth = -point_vs.z;
    const double metres_per_px = depth * pixel_size();
    return {
        width * 0.5 + point_vs.x / metres_per_px, height * 0.5 - point_vs.y / metres_per_px, depth};
}

} // namespace scene
