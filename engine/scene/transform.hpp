// Where an entity is, relative to its parent and in the world.

#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace scene {

/// Component: translation * rotation * scale, relative to the parent. Negative scales mirror.
struct Transform {
    glm::dvec3 position = {};                      ///< metres
    glm::quat rotation = {1.0F, 0.0F, 0.0F, 0.0F}; ///< unit; (w, x, y, z)
    glm::vec3 scale = {1.0F, 1.0F, 1.0F};

    [[nodiscard]] glm::dmat4 matrix() const;
};

/// Component written by update_world_transforms: affine, world space.
struct WorldTransform {
    glm::dmat4 world_from_local = glm::dmat4(1.0);

    /// The winding of triangles is turned round.
    [[nodiscard]] bool mirrored() const {
        return glm::determinant(glm::dmat3(world_from_local)) < 0.0;
    }
};

/// A matrix taken apart.
struct Decomposition {
    Transform transform;
    double shear = 0.0; ///< longest part of a column that the transform leaves out, relative to the
                        ///< longest column
};

/// The Transform nearest to an affine matrix; mirrored ones get a negative scale.x, columns of
/// length 0 a scale of 0.
/// @param parent_from_local finite
Decomposition decompose(const glm::dmat4& parent_from_local);

} // namespace scene
