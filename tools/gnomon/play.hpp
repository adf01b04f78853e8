// The ways to play a level: by hand in a window, by itself without one, and for long.

#pragma once

#include <filesystem>
#include <string>

#include "tools/gnomon/studio.hpp"
#include "tools/gnomon/view_options.hpp"

namespace gnomon {

struct PlayOptions {
    std::string level = "games/sample/level.lua";
    std::filesystem::path out = "out/play";
    ViewOptions view = {.size = "640x360", .camera = {}};
    double walk_seconds = 0.0; ///< 0: once round
    double soak_seconds = 0.0; ///< 0: no soak
    int window_frames = 0;     ///< 0: until the window is closed
    bool headless = false;
};

/// W A S D and the mouse (or a gamepad) move the player (or a camera that flies, where the level
/// has none), left shift runs, F12 takes a picture, Escape ends.
/// Errors: no display, or no OpenGL on it.
engine::Result<void>
play_in_window(Level& level, const PlayOptions& options, const glm::ivec2& size);

/// The player walks its path once round, or for walk_seconds; a level without one shows its
/// cameras. Leaves stills, a film where ffmpeg is installed,
/// and index.html.
/// @return a sentence that says what lies where
/// Errors: the folder cannot be written.
engine::Result<std::string>
walk_through(Studio& studio, Level& level, const PlayOptions& options, const glm::ivec2& size);

/// Walks for soak_seconds of the level's time, without pictures, and tells what it holds.
/// @return false: memory, device memory, OpenGL objects, open files or entities grew
engine::Result<bool>
soak(Studio& studio, Level& level, const PlayOptions& options, const glm::ivec2& size);

} // namespace gnomon
