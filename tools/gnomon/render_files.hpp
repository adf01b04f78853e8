// The files of `gnomon render`: color.png, mask_<light>.png, ids.png, plans.json and stats.json.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/gnomon/frame_times.hpp"
#include "tools/gnomon/view_options.hpp"

namespace gnomon {

/// Why the technique asked for cannot serve this level's lights in this build, or nothing.
std::optional<std::string>
unsupported(Studio& studio, const Level& level, const ShadowOptions& options);

/// Writes what the studio drew last.
/// @param times none: stats.json holds no times
/// @param hash prints "hash NAME 0123456789abcdef" for every picture (FNV-1a over its pixels)
/// Errors: the folder cannot be made or written.
engine::Result<void> write_render_files(
    Studio& studio,
    const std::filesystem::path& folder,
    const std::optional<FrameTimes>& times,
    bool hash);

} // namespace gnomon
