// Where to look from when nobody said.

#pragma once

#include "engine/scene/camera.hpp"
#include "engine/scene/world.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace scene {

/// The rotation that turns -Z along `direction`, with +Y as far up as it can be.
/// @pre direction has a length
glm::quat rotation_along(const glm::dvec3& direction);

/// A camera that sees the whole world from the front, the right and above. An empty world counts as
/// a metre.
/// @param width, height of the picture, pixels; > 0
CameraView frame_scene(const World& world, int width, int height);

} // namespace scene
