#include "engine/scene/transform.hpp"

#include <algorithm>

namespace scene {

namespace {

/// What is left of a vector when its parts along the columns of `basis` (unit or zero) are taken
/// away.
glm::dvec3 rejected(glm::dvec3 vector, const glm::dmat3& basis) {
    for (int axis = 0; axis < 3; ++axis)
        vector -= basis[axis] * glm::dot(basis[axis], vector);
    return vector;
}

/// The direction of `column` at right angles to `basis`, or of the coordinate axis that is most so
/// when the column has none.
glm::dvec3 next_direction(const glm::dvec3& column, const glm::dmat3& basis) {
    glm::dvec3 best = rejected(column, basis);
    if (glm::length(best) > 1e-6 * glm::length(column)) return glm::normalize(best);
    best = {};
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 candidate = rejected(glm::dmat3(1.0)[axis], basis);
        if (glm::length(candidate) > glm::length(best)) best = candidate;
    }
    return glm::normalize(best);
}

/// A right-handed or left-handed rotation nearest to the columns in their order; those without
/// length come last.
glm::dmat3 orthonormal(const glm::dmat3& columns) {
    glm::dmat3 basis(0.0);
    for (const bool has_length : {true, false})
        for (int axis = 0; axis < 3; ++axis)
            if ((glm::length(columns[axis]) > 0.0) == has_length)
                basis[axis] = next_direction(columns[axis], basis);
    return basis;
}

} // namespace

glm::dmat4 Transform::matrix() const {
    glm::dmat4 parent_from_local(glm::mat3_cast(glm::dquat(rotation)));
    for (int axis = 0; axis < 3; ++axis)
        parent_from_local[axis] *= static_cast<double>(scale[axis]);
    parent_from_local[3] = glm::dvec4(position, 1.0);
    return parent_from_local;
}

Decomposition decompose(const glm::dmat4& parent_from_local) {
    const glm::dmat3 columns(parent_from_local);
    glm::dmat3 basis = orthonormal(columns);
    glm::dvec3 scale;
    for (int axis = 0; axis < 3; ++axis)
        scale[axis] = glm::dot(basis[axis], columns[axis]);
    if (glm::determinant(basis) < 0.0) {
        basis[0] = -basis[0];
        scale.x = -scale.x;
    }

    Decomposition result;
    result.transform.position = glm::dvec3(parent_from_local[3]);
    result.transform.rotation = glm::normalize(glm::quat(glm::quat_cast(basis)));
    result.transform.scale = glm::vec3(scale);
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        longest = std::max(longest, glm::length(columns[axis]));
        result.shear =
            std::max(result.shear, glm::length(columns[axis] - basis[axis] * scale[axis]));
    }
    if (longest > 0.0) result.shear /= longest;
    return result;
}

} // namespace scene
