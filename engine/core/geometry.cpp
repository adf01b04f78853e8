#include "engine/core/geometry.hpp"

#include <cmath>

namespace engine {

bool Frustum::intersects(const Aabb& box) const {
    const glm::vec3 centre = box.centre();
    const glm::vec3 half = box.extent() * 0.5F;
    for (const Plane& plane : planes) {
        const float reach = glm::dot(glm::abs(plane.normal), half);
        if (plane.distance(centre) < -reach) return false;
    }
    return true;
}

Frustum frustum_from_clip(const glm::mat4& clip_from_space) {
    const glm::mat4 rows = glm::transpose(clip_from_space);
    const std::array<glm::vec4, 5> equations = {
        rows[3] + rows[0],
        rows[3] - rows[0],
        rows[3] + rows[1],
        rows[3] - rows[1],
        rows[3] - rows[2]};
    Frustum frustum;
    for (std::size_t i = 0; i < equations.size(); ++i) {
        const float length = glm::length(glm::vec3(equations[i]));
        frustum.planes[i] = {glm::vec3(equations[i]) / length, equations[i].w / length};
    }
    return frustum;
}

WorldAabb transformed(const glm::dmat4& world_from_mesh, const Aabb& box) {
    if (box.empty()) return {};
    const glm::dvec3 centre(box.centre());
    const glm::dvec3 half = glm::dvec3(box.extent()) * 0.5;
    const glm::dmat3 linear(world_from_mesh);
    const glm::dvec3 moved = glm::dvec3(world_from_mesh * glm::dvec4(centre, 1.0));
    const glm::dvec3 reach =
        glm::abs(linear[0]) * half.x + glm::abs(linear[1]) * half.y + glm::abs(linear[2]) * half.z;
    return {moved - reach, moved + reach};
}

Aabb relative_to(const WorldAabb& box, const glm::dvec3& origin) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Aabb relative;
    for (int axis = 0; axis < 3; ++axis) {
        relative.min[axis] =
            std::nextafter(static_cast<float>(box.min[axis] - origin[axis]), -kInfinity);
        relative.max[axis] =
            std::nextafter(static_cast<float>(box.max[axis] - origin[axis]), kInfinity);
    }
    return relative;
}

} // namespace engine
