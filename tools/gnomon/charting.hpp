// Trying settings on the lights of a level, one light alone at a time: what each adds to a frame,
// and how far it is from ray-traced truth.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/chart/chart.hpp"
#include "tools/gnomon/chart_settings.hpp"
#include "tools/gnomon/frame_times.hpp"

namespace gnomon {

struct ChartingOptions {
    std::vector<std::string> words; ///< settings to try
    std::string light;              ///< its name; empty: every light
    TimingOptions timing;           ///< 0 frames: predicted costs alone
    int truth_samples = 256;        ///< of area lights
};

/// Indices of the lights that a chart is asked for.
/// Errors: none there, or none of that name, with the nearest.
engine::Result<std::vector<std::size_t>>
charted_lights(const std::vector<scene::PlacedLight>& lights, const std::string& name);

/// A chart for each light; where there are several, one more for all of them, whose points are sums
/// over the lights at the same setting. Every job is redrawn in every frame, so that no cache
/// flatters a cost. Settings that cannot serve a light are its chart's refusals.
/// @param progress told what is being done; empty: done
/// Errors: those of charted_lights(); a picture that cannot be read back.
engine::Result<std::vector<chart::Chart>> chart_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const ChartingOptions& options,
    const std::function<void(const std::string&)>& progress);

} // namespace gnomon
