#include "systems/shadows/maps/local_fit.hpp"

#include <cmath>

namespace shadows {

namespace {

/// Grows a view by texels on each side.
void grow(PyramidView& view, int border) {
    const glm::dvec2 texel = (view.max - view.min) / (view.size - 2.0 * border);
    view.min -= texel * static_cast<double>(border);
    view.max += texel * static_cast<double>(border);
}

/// Shrinks a view to what boxes cover of it; leaves it where one of them reaches round the light.
void crop(PyramidView& view, std::span<const engine::WorldAabb> boxes) {
    glm::dvec2 min = view.max;
    glm::dvec2 max = view.min;
    for (const engine::WorldAabb& box : boxes) {
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 p = view.light_from_world * (box.corner(i) - view.position);
            if (p.z <= 1e-3 * glm::length(p)) return;
            min = glm::min(min, glm::dvec2(p) / p.z);
            max = glm::max(max, glm::dvec2(p) / p.z);
        }
    }
    min = glm::max(min, view.min);
    max = glm::min(max, view.max);
    if (glm::any(glm::greaterThanEqual(min, max))) return;
    view.min = min;
    view.max = max;
}

} // namespace

PyramidView spot_view(
    const LightView& light,
    std::span<const engine::WorldAabb> casters,
    int size,
    int border,
    double reach) {
    const glm::dvec3 forward(light.direction);
    const glm::dvec3 side =
        std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, side));
    PyramidView view;
    view.position = light.position;
    view.light_from_world = axes_from_rows(right, glm::cross(right, forward), forward);
    view.max = glm::dvec2(std::tan(static_cast<double>(light.light.outer_angle)) + reach);
    view.min = -view.max;
    view.size = size;
    crop(view, casters);
    grow(view, border);
    return view;
}

glm::dmat3 cube_turn() {
    return axes_from_rows(
        glm::dvec3(2.0, -1.0, 2.0) / 3.0,
        glm::dvec3(2.0, 2.0, -1.0) / 3.0,
        glm::dvec3(-1.0, 2.0, 2.0) / 3.0);
}

std::array<PyramidView, 6>
cube_views(const glm::dvec3& position, int size, int border, double reach) {
    std::array<PyramidView, 6> views;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double sign = face % 2 == 0 ? 1.0 : -1.0;
        // face_axes of map_mask.frag finds its faces in the same way.
        glm::dvec3 forward(0.0);
        glm::dvec3 right(0.0);
        glm::dvec3 up(0.0);
        forward[axis] = sign;
        right[(axis + 1) % 3] = -sign;
        up[(axis + 2) % 3] = 1.0;
        PyramidView& view = views[static_cast<std::size_t>(face)];
        view.position = position;
        view.light_from_world = axes_from_rows(right, up, forward) * cube_turn();
        view.size = size;
        view.max += reach;
        view.min -= reach;
        grow(view, border);
    }
    return views;
}

bool sees(const PyramidView& view, const engine::WorldAabb& box) {
    // Behind one of the four sides, or behind the light: then all corners are.
    bool outside[5] = {true, true, true, true, true};
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = view.light_from_world * (box.corner(i) - view.position);
        outside[0] = outside[0] && p.x > p.z * view.max.x;
        outside[1] = outside[1] && p.x < p.z * view.min.x;
        outside[2] = outside[2] && p.y > p.z * view.max.y;
        outside[3] = outside[3] && p.y < p.z * view.min.y;
        outside[4] = outside[4] && p.z < 0.0;
    }
    return !(outside[0] || outside[1] || outside[2] || outside[3] || outside[4]);
}

} // namespace shadows
