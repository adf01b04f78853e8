// A scene file (.lua, .glb or .gltf) as a world that is ready to be drawn.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/description.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/world.hpp"
#include "engine/script/level_script.hpp"
#include "systems/shadows/shadow_settings.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

struct Level {
    std::filesystem::path file; ///< that it was loaded from
    std::string name;           ///< file name without its extension
    scene::World world;
    shadows::ShadowSettings shadows;
    std::optional<float> exposure;
    std::optional<scene::PlayerDescription> player;
    std::unique_ptr<script::LevelScript> script; ///< of a level that acts
    std::vector<std::string> warnings;           ///< one sentence each
};

/// Loads, builds and poses the scene at time 0.
/// Errors: every mistake in the file, a line each.
engine::Result<Level> load_level(const std::filesystem::path& file);

/// Lets the level live for dt seconds: on_update, then everything that moves by itself. Tells what
/// its script prints, and its mistake once.
void advance(Level& level, float dt);

/// The camera of that name; with an empty name the file's first, else one that frames the scene.
/// Errors: no camera of that name, with the nearest one.
engine::Result<scene::CameraView>
choose_camera(const Level& level, const std::string& name, int width, int height);

/// Prints warnings on standard error.
void print_warnings(const Level& level);

} // namespace gnomon
