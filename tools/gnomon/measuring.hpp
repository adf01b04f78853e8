// Measuring one level: truth, masks of every technique, figures.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/gnomon/frame_times.hpp"
#include "tools/gnomon/view_options.hpp"
#include "tools/measure/report.hpp"

namespace gnomon {

class Progress;
class RowJournal;

struct MeasureOptions {
    std::vector<std::string> techniques = {"auto"};
    std::vector<std::string> protocols = {"still"}; ///< of protocol_names()
    int moving_frames = 64;
    int truth_samples = 256; ///< of area lights
    TimingOptions timing;
    std::filesystem::path pictures; ///< folder for each row's; empty: none
    RowJournal* journal = nullptr;  ///< rows that are in it are not measured again; may be null
    Progress* progress = nullptr;   ///< null: of this level alone
};

/// Adds one row for every light, protocol and technique, those of the
/// journal included. Progress goes to standard error.
/// Still: every figure of a picture, and 16 frames in which nothing may change. The other protocols
/// move something, 60 frames a second (see motion_protocols.hpp), with the truth traced for every
/// frame.
/// Errors: a shader or a file that fails. A technique that cannot serve becomes a row with a note.
engine::Result<void> measure_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    measure::Report& report);

} // namespace gnomon
