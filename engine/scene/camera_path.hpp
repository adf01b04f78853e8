// A smooth way through the cameras of a level: what shows a level when nobody plays it.

#pragma once

#include "engine/scene/camera.hpp"

#include <vector>

namespace scene {

/// The view at `at` in [0, 1] along the stops, which are spread evenly. Positions follow a spline
/// through the stops, turns are the shortest. One stop: a slow turn of 30 degrees to each side.
/// @pre not empty
/// Source: Catmull and Rom, "A Class of Local Interpolating Splines", 1974.
CameraView view_along(const std::vector<CameraView>& stops, double at);

} // namespace scene
