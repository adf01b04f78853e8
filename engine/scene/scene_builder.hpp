// From descriptions and files to a world with entities in it.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/description.hpp"
#include "engine/scene/world.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace scene {

/// What is worth telling about a level that works, one sentence each.
using Warnings = std::vector<std::string>;

/// Adds everything in a level to `world` and places it. Each model file is read once, each shape
/// made once.
/// @param folder that model files are relative to: the level's own
/// Errors: a model file that cannot be read, or has no clip of the name asked for; `world` is then
/// half made.
engine::Result<Warnings>
build_world(const SceneDescription& description, const std::filesystem::path& folder, World& world);

/// Adds a plain model file with its own lights and cameras to `world`. A file without light gets a
/// sun named "sun", and a warning; one without a camera gets a warning (see frame_scene). Errors:
/// those of load_gltf().
engine::Result<Warnings> build_world_from_gltf(const std::filesystem::path& file, World& world);

} // namespace scene
