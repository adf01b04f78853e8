#include "engine/scene/framing.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>

namespace scene {

glm::quat rotation_along(const glm::dvec3& direction) {
    CHECK(glm::length(direction) > 0.0);
    const glm::dvec3 back = -glm::normalize(direction);
    glm::dvec3 right = glm::cross(glm::dvec3(0.0, 1.0, 0.0), back);
    if (glm::length(right) < 1e-6)
        right = {1.0, 0.0, 0.0}; // straight up or down: any right will do
    right = glm::normalize(right - back * glm::dot(right, back));
    const glm::dmat3 world_from_local(right, glm::cross(back, right), back);
    return glm::normalize(glm::quat(glm::quat_cast(world_from_local)));
}

CameraView frame_scene(const World& world, int width, int height) {
    CHECK(width > 0 && height > 0);
    engine::WorldAabb bounds = world_bounds(world);
    if (bounds.empty()) {
        bounds.grow(glm::dvec3(-0.5));
        bounds.grow(glm::dvec3(0.5));
    }
    const double radius = std::max(glm::length(bounds.extent()) / 2.0, 1e-3);
    const glm::dvec3 from = glm::normalize(glm::dvec3(0.6, 0.5, 1.0));

    CameraView view;
    view.name = "framed";
    view.width = width;
    view.height = height;
    view.world_from_view = glm::mat3_cast(rotation_along(-from));
    const double half_y = static_cast<double>(view.fov_y) / 2.0;
    const double half_x = std::atan(std::tan(half_y) * view.aspect());
    const double distance = radius / std::sin(std::min(half_x, half_y));
    view.position = bounds.centre() + from * distance;
    view.near = static_cast<float>(std::max(distance - radius, radius * 1e-2));
    return view;
}

} // namespace scene
