// Ways through a level, as plain points, and where something on its way is.

#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace scene {

/// Straight from point to point.
struct Path {
    std::string name;
    std::vector<glm::dvec3> points; ///< metres; at least two that differ
    bool closed = true;             ///< goes on from the last point to the first; else to and fro
};

/// Metres until something on the path is back where it began, looking the same way.
double period(const Path& path);

struct PathPlace {
    glm::dvec3 position = {};
    double heading = 0.0; ///< turn about y that takes +Z to the way ahead, radians
};

/// @param travelled metres from the first point; any number
/// Turns begin and end 0.4 m from a corner, or half a leg where that is less.
PathPlace place_on(const Path& path, double travelled);

} // namespace scene
