// Rotations as people write them.

#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/euler_angles.hpp>

namespace scene {

/// @param turns about x, y and z, radians; applied in the order z, x, y (roll, pitch, yaw)
inline glm::quat turned_by(const glm::dvec3& turns) {
    const glm::dquat yaw = glm::angleAxis(turns.y, glm::dvec3(0.0, 1.0, 0.0));
    const glm::dquat pitch = glm::angleAxis(turns.x, glm::dvec3(1.0, 0.0, 0.0));
    const glm::dquat roll = glm::angleAxis(turns.z, glm::dvec3(0.0, 0.0, 1.0));
    return glm::normalize(glm::quat(yaw * pitch * roll));
}

/// What turned_by() would make the rotation of. @param rotation unit
inline glm::dvec3 turns_of(const glm::quat& rotation) {
    glm::dvec3 turns = {};
    glm::extractEulerAngleYXZ(
        glm::dmat4(glm::mat4_cast(glm::dquat(rotation))), turns.y, turns.x, turns.z);
    return turns;
}

} // namespace scene
