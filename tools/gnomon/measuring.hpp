// Measuring one level: truth, masks of every technique, figures.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/gnomon/frame_times.hpp"
#include "tools/gnomon/view_options.hpp"
#include "tools/measure/report.hpp"

namespace gnomon {

struct MeasureOptions {
    std::vector<std::string> techniques = {"auto"};
    std::string protocol = "still"; ///< "still", "walk" or "both"
    int walk_frames = 64;
    int truth_samples = 256; ///< of area lights
    TimingOptions timing;
    std::filesystem::path pictures; ///< folder for truth, masks and error pictures
};

/// Adds one row for every light and technique. Progress goes to standard error.
/// Still: the camera where it is, and 16 frames in which nothing may change.
/// Walk: the camera moves along its view at 1.4 m/s, 60 frames a second, while everything else
/// stands still; truth is traced for every frame. Errors: a shader or a file that fails. A
/// technique that cannot serve becomes a row with a note.
engine::Result<void> measure_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    measure::Report& report);

} // namespace gnomon
