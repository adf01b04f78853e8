// Levels: from a Lua file to a checked scene description, or to all its mistakes.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/description.hpp"
#include "engine/script/level_script.hpp"
#include "engine/script/lua_state.hpp"
#include "engine/script/scene_schema.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace script {

struct LoadedScene {
    std::optional<scene::SceneDescription> scene; ///< present when there are no errors
    std::unique_ptr<LevelScript> script;      ///< of a level without errors that has an on_update
    std::vector<engine::Error> errors;        ///< all of them, by file and line
    std::vector<std::string> warnings;        ///< one sentence each, with its place
    std::vector<std::filesystem::path> files; ///< the level and every file it required
    std::vector<std::string> output;          ///< what the level printed

    /// All errors, a line each, as a person should see them.
    [[nodiscard]] std::string error_text() const;
};

/// Runs a level, checks it whole, and checks that its model files are there.
/// Errors: in LoadedScene, so that all come at once. Never hangs: `limits` hold for the whole run.
LoadedScene load_scene(
    const std::filesystem::path& file,
    const SceneVocabulary& vocabulary,
    const LuaLimits& limits = {});

/// The same from memory: it may require only what ships with the engine, and model files are not
/// looked for.
/// @param name shown in messages
LoadedScene load_scene_text(
    std::string_view text,
    const std::string& name,
    const SceneVocabulary& vocabulary,
    const LuaLimits& limits = {});

} // namespace script
