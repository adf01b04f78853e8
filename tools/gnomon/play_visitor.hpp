// Who looks at a level when nobody is at the keys: a player that walks its path by the same rules
// as a person, or, where the level has none, a camera on its way through the level's cameras.

#pragma once

#include "engine/app/first_person.hpp"
#include "engine/app/route_hands.hpp"

#include <optional>
#include <vector>

#include "tools/gnomon/level.hpp"

namespace gnomon {

class Visitor {
public:
    /// @param flight_seconds that a camera takes for one round
    /// @pre the level stays
    Visitor(const Level& level, const glm::ivec2& size, double flight_seconds);

    /// Goes on; 0 looks at where it is.
    scene::CameraView advance(double seconds);

    /// How often the whole way was gone.
    [[nodiscard]] int rounds() const;
    /// How many points of the path could not be reached.
    [[nodiscard]] int missed() const { return hands_ ? hands_->missed() : 0; }

private:
    glm::ivec2 size_;
    double flight_seconds_;
    double time_ = 0.0;
    std::vector<scene::CameraView> stops_;
    play::Obstacles obstacles_;
    std::optional<app::FirstPerson> person_;
    std::optional<app::RouteHands> hands_;
    app::Input input_;
};

} // namespace gnomon
