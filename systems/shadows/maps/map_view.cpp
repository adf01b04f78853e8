#include "systems/shadows/maps/map_view.hpp"

namespace shadows {

namespace {

/// The matrix whose rows are given.
glm::dmat4
from_rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
    return glm::transpose(glm::dmat4(x, y, z, w));
}

glm::dvec3 row(const glm::dmat3& matrix, int index) {
    return {matrix[0][index], matrix[1][index], matrix[2][index]};
}

} // namespace

glm::dmat3
axes_from_rows(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& forward) {
    return glm::transpose(glm::dmat3(right, up, forward));
}

glm::dmat4 ParallelView::map_from_world() const {
    const glm::dvec2 side = texel * static_cast<double>(size);
    const double depth = farthest - nearest;
    return from_rows(
        glm::dvec4(row(light_from_world, 0), -min.x) / side.x,
        glm::dvec4(row(light_from_world, 1), -min.y) / side.y,
        glm::dvec4(-row(light_from_world, 2), farthest) / depth,
        {0.0, 0.0, 0.0, 1.0});
}

glm::dmat4 PyramidView::map_from_world() const {
    const auto placed = [&](const glm::dvec3& axis) {
        return glm::dvec4(axis, -glm::dot(axis, position));
    };
    const glm::dvec4 forward = placed(row(light_from_world, 2));
    const glm::dvec2 side = max - min;
    return from_rows(
        (placed(row(light_from_world, 0)) - forward * min.x) / side.x,
        (placed(row(light_from_world, 1)) - forward * min.y) / side.y,
        {0.0, 0.0, 0.0, near},
        forward);
}

glm::dmat4 clip_from_map() {
    return from_rows(
        {2.0, 0.0, 0.0, -1.0}, {0.0, 2.0, 0.0, -1.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0});
}

} // namespace shadows
