// The two ways to play a level: by hand in a window, and by itself without one.

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
    double walk_seconds = 8.0;
    int window_frames = 0; ///< 0: until the window is closed
    bool headless = false;
};

/// W A S D and the mouse (or a gamepad) move the camera, F12 takes a picture, Escape ends.
/// Errors: no display, or no OpenGL on it.
engine::Result<void>
play_in_window(Level& level, const PlayOptions& options, const glm::ivec2& size);

/// The camera goes through the level's cameras. Leaves stills, a film where ffmpeg is installed,
/// and index.html.
/// @return a sentence that says what lies where
/// Errors: the folder cannot be written.
engine::Result<std::string>
walk_through(Studio& studio, Level& level, const PlayOptions& options, const glm::ivec2& size);

} // namespace gnomon
