// Measuring one level: truth, masks of every technique, figures.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/gnomon/frame_times.hpp"
#include "tools/gnomon/view_options.hpp"
#include "tools/measure/report.hpp"

namespace gnomon {

/// What the camera can do.
inline const std::vector<std::string> kProtocols = {"still", "walk", "yaw"};

struct MeasureOptions {
    std::vector<std::string> techniques = {"auto"};
    std::vector<std::string> protocols = {"still"}; ///< of kProtocols
    int moving_frames = 64;
    int truth_samples = 256; ///< of area lights
    TimingOptions timing;
    std::filesystem::path pictures; ///< folder for truth, masks and error pictures
};

/// Adds one row for every light, protocol and technique. Progress goes to standard error.
/// Still: the camera where it is, and 16 frames in which nothing may change.
/// Walk: the camera moves along its view at 1.4 m/s, 60 frames a second, while everything else
/// stands still; truth is traced for every frame. Yaw: it turns to the left by a degree a frame.
/// Errors: a shader or a file that fails. A technique that cannot serve becomes a row with a note.
engine::Result<void> measure_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    measure::Report& report);

} // namespace gnomon
