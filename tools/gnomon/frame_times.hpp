// Timing frames honestly: with and without shadows in alternating rounds, the device's work
// finished inside each frame, and passes in a profiling run of their own.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/gnomon/studio.hpp"

namespace gnomon {

struct TimingOptions {
    int frames = 0;        ///< of each kind; 0: nothing is timed
    int warmup = 3;        ///< frames drawn after each switch, not timed
    double seconds = 10.0; ///< timing stops after this long even if frames remain
};

struct FrameStatistics {
    double median_ms = 0.0;
    double min_ms = 0.0;
    double p99_ms = 0.0;
};

/// @pre not empty
FrameStatistics statistics(std::vector<double> frame_ms);

struct FrameTimes {
    int frames = 0; ///< timed, of each kind
    FrameStatistics with;
    FrameStatistics without;
    std::vector<gpu::PassTime> passes; ///< medians of the frame with shadows, in its order
};

/// @param draw draws one frame; called with false for frames without shadows
/// Errors: those of draw.
engine::Result<FrameTimes> time_frames(
    Studio& studio,
    const TimingOptions& options,
    const std::function<engine::Result<void>(bool)>& draw);

} // namespace gnomon
