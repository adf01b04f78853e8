// Where an entity is, relative to its parent and in the world.

#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace scene {

/// Component: translation * rotation * scale, relative to the parent. Negative scales mirror.
struct Transform {
    glm::dvec3 position = {};                            ///< metres
    glm::quat rotation = {1.0F, 0.0F, 0.0F, 0.0F};       ///< unit; (w, x, y, z)
    glm::vec3 scale = {1.0F, 1.0F, 1.0F};

    [[nodiscard]] glm::dmat4 matrix() const;
};

/// Component written by update_world_transforms: affine, world space.
struct WorldTransform {
    glm::dmat4 world_from_local = glm::dmat4(1.0);

    /// The winding of triangles is turned round.
    [[nodiscard]] bool mirrored() const { return glm::determinant(glm::dmat3(world_from_local)) < 0.0; }
};

} // namespace scene
