// Hands that walk a route: what a person would do at the sticks to get from point to point.

#pragma once

#include "engine/app/first_person.hpp"
#include "engine/app/input.hpp"
#include "engine/scene/path.hpp"

namespace app {

class RouteHands {
public:
    /// Begins with the path's first point.
    explicit RouteHands(scene::Path path) : path_(std::move(path)) {}

    /// What the hands do in the next frame. A point that cannot be reached is given up after a
    /// while.
    RawInput take(const FirstPerson& person, double seconds);

    /// How often the last point has been passed.
    [[nodiscard]] int rounds() const { return rounds_; }
    /// How many points were given up.
    [[nodiscard]] int missed() const { return missed_; }

private:
    void next();

    scene::Path path_;
    std::size_t target_ = 0;
    int rounds_ = 0;
    int missed_ = 0;
    bool back_ = false;    ///< of a path that goes to and fro
    double nearest_ = 1e9; ///< that the target has been, metres
    double waited_ = 0.0;  ///< seconds since it came nearer
};

} // namespace app
