// Everything that a measured row depends on, as a value that can be compared.

#pragma once

#include "engine/core/result.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "tools/gnomon/measuring.hpp"

namespace gnomon {

/// What the files of a scene say, as a number: of the file itself and of every file that it names
/// in quotes (models, textures, buffers, and Lua modules with or without ".lua"), and of those that
/// they name. Names are looked up beside the file that names them, and beside the scene.
/// Errors: the file cannot be read.
engine::Result<std::string> scene_digest(const std::filesystem::path& file);

/// Which program draws: when it was linked, and, where shaders are read from disk, when the newest
/// one was written.
std::string program_stamp();

/// What all rows of a level have in common.
/// Errors: the level's file cannot be read.
engine::Result<nlohmann::json> level_key(
    const Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    const std::string& renderer);

/// The key of one row.
nlohmann::json row_key(
    const nlohmann::json& level_key,
    const MeasureOptions& options,
    const std::string& light,
    const std::string& technique,
    const std::string& protocol);

} // namespace gnomon
