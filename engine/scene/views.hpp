// Lights and cameras of a world as plain values, placed.

#pragma once

#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/world.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scene {

/// Every light that is on, sorted by name. @pre update_world_transforms() ran since the last change
std::vector<PlacedLight> placed_lights(const World& world);

/// The names of all cameras, the oldest entity first.
std::vector<std::string> camera_names(const World& world);

/// @param name of a camera's entity; empty for the oldest one
/// @param width, height of the picture, pixels
/// @return nothing when there is no such camera
/// @pre update_world_transforms() ran since the last change
std::optional<CameraView>
find_camera(const World& world, std::string_view name, int width, int height);

} // namespace scene
