#include "engine/app/look.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace app {

Look Look::of(const glm::mat3& world_from_view) {
    const glm::vec3 back = world_from_view[2];
    return {std::atan2(back.x, back.z), -std::asin(std::clamp(back.y, -1.0F, 1.0F))};
}

void Look::turn(const Input& input, float seconds) {
    constexpr float kTurnPerPixel = 0.0025F; // rad
    constexpr float kSteepest = 1.55F;
    const glm::vec2 moved = input.pointer_delta_px() * kTurnPerPixel;
    yaw -= moved.x + input.axis(Axis::right_x) * kStickTurn * seconds;
    pitch = std::clamp(
        pitch - moved.y + input.axis(Axis::right_y) * kStickTurn * seconds, -kSteepest, kSteepest);
}

glm::mat3 Look::world_from_view() const {
    return glm::mat3_cast(
        glm::angleAxis(yaw, glm::vec3(0.0F, 1.0F, 0.0F))
        * glm::angleAxis(pitch, glm::vec3(1.0F, 0.0F, 0.0F)));
}

} // namespace app
