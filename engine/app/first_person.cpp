#include "engine/app/first_person.hpp"

#include <cmath>

namespace app {

FirstPerson::FirstPerson(const scene::PlayerDescription& player)
    : player_(player),
      stance_{.feet = player.position},
      look_{player.heading, 0.0F} {}

void FirstPerson::move(const play::Obstacles& obstacles, const Input& input, double seconds) {
    constexpr double kRunning = 2.5; // times as fast
    constexpr double kLost = 50.0;   // m below everything
    look_.turn(input, static_cast<float>(seconds));
    const double speed =
        static_cast<double>(player_.speed) * (input.down(Key::left_shift) ? kRunning : 1.0);
    const glm::dvec2 wish = input.walk();
    const double yaw = look_.yaw;
    const glm::dvec2 right(std::cos(yaw), -std::sin(yaw));
    const glm::dvec2 ahead(-std::sin(yaw), -std::cos(yaw));
    stance_ =
        play::moved(obstacles, body_, stance_, speed * (wish.x * right + wish.y * ahead), seconds);
    const engine::WorldAabb bounds = obstacles.bounds();
    const double lowest = bounds.empty() ? player_.position.y : bounds.min.y;
    if (stance_.feet.y < lowest - kLost) *this = FirstPerson(player_);
}

scene::CameraView FirstPerson::view(const glm::ivec2& size_px) const {
    scene::CameraView view;
    view.name = "player";
    view.position = stance_.eye(body_);
    view.world_from_view = look_.world_from_view();
    view.near = 0.05F;
    view.width = size_px.x;
    view.height = size_px.y;
    return view;
}

} // namespace app
