#include "systems/shadows/volumes/near_clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadows {

namespace {

/// The caster's box, relative to the camera.
struct Box {
    glm::dvec3 centre;
    glm::dvec3 half;

    /// Whether the box lies before the plane through `point`, farther than rounding goes.
    [[nodiscard]] bool before(const glm::dvec3& normal, const glm::dvec3& point) const {
        constexpr double kRounding = 1e-9;
        const double reach = glm::dot(glm::abs(normal), half);
        return glm::dot(normal, centre - point) - reach
               > kRounding * glm::length(normal) * glm::length(centre);
    }
};

} // namespace

std::array<glm::dvec3, 4> near_rectangle(const scene::CameraView& camera) {
    const auto near = static_cast<double>(camera.near);
    const auto width = static_cast<double>(camera.width);
    const auto height = static_cast<double>(camera.height);
    return {
        camera.ray_direction(0.0, 0.0) * near,
        camera.ray_direction(width, 0.0) * near,
        camera.ray_direction(width, height) * near,
        camera.ray_direction(0.0, height) * near};
}

bool may_shade_near_plane(
    const scene::CameraView& camera, const LightView& light, const engine::WorldAabb& caster) {
    const auto corners = near_rectangle(camera);
    const Box box{caster.centre() - camera.position, caster.extent() * 0.5};
    const bool sun = light.light.kind == scene::LightKind::directional;
    const glm::dvec3 apex = light.position - camera.position; // of a lamp
    const glm::dvec3 to_sun = -glm::dvec3(light.direction);
    const glm::dvec3 middle = (corners[0] + corners[2]) * 0.5;
    const glm::dvec3 to_light = sun ? to_sun : apex - middle;

    // The rectangle's own plane: what is on the other side of it than the light shades it not.
    const glm::dvec3 view(-glm::dvec3(camera.world_from_view[2]));
    const double toward = glm::dot(view, to_light);
    if (toward != 0.0 && box.before(toward > 0.0 ? -view : view, middle)) return false;
    // The sides of the pyramid or prism.
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % 4];
        glm::dvec3 normal = glm::cross(b - a, sun ? to_sun : apex - a);
        if (glm::dot(normal, middle - a) > 0.0) normal = -normal;
        if (box.before(normal, a)) return false;
    }
    // The box's own faces: the pyramid has five corners, the prism goes on along the way to the
    // sun.
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            double least =
                sun ? sign * to_sun[axis] < 0.0 ? -HUGE_VAL : HUGE_VAL : sign * apex[axis];
            for (const glm::dvec3& corner : corners)
                least = std::min(least, sign * corner[axis]);
            if (least > sign * box.centre[axis] + box.half[axis]) return false;
        }
    return true;
}

} // namespace shadows
