// Where a person looks: turned by the mouse and the right stick.

#pragma once

#include "engine/app/input.hpp"

#include <glm/glm.hpp>

namespace app {

struct Look {
    float yaw = 0.0F;   ///< turn about y, radians; 0 looks along -z
    float pitch = 0.0F; ///< up is positive, radians

    /// The way that a view looks. @param world_from_view columns are right, up, back
    static Look of(const glm::mat3& world_from_view);

    void turn(const Input& input, float seconds);
    /// Columns are right, up, back.
    [[nodiscard]] glm::mat3 world_from_view() const;
};

/// Radians a second of a stick that is tilted all the way.
inline constexpr float kStickTurn = 2.0F;

} // namespace app
