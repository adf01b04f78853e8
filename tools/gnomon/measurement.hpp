// One level held against its truth: what stills and motions have in common. Draws frames with the
// technique asked for, traces the truth of a light, and brings both together.

#pragma once

#include <string>

#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/measuring.hpp"

namespace gnomon {

class Measurement {
public:
    /// @param studio, level, options, progress outlive it
    Measurement(Studio& studio, Level& level, const MeasureOptions& options, Progress& progress);

    /// A row for a light and a technique, with everything but figures.
    [[nodiscard]] measure::Row
    row(const scene::CameraView& camera,
        const scene::PlacedLight& light,
        const std::string& technique,
        const std::string& protocol) const;

    /// Of the level as it stands now.
    [[nodiscard]] truth::TruthImage
    truth(const scene::CameraView& camera, const scene::PlacedLight& light);
    /// The same half a pixel beside, see truth::second_grid().
    [[nodiscard]] trace::VisibilityImage
    second_truth(const scene::CameraView& camera, const scene::PlacedLight& light);

    /// Draws a frame with a technique. Errors: why it cannot serve.
    engine::Result<void> draw(const scene::CameraView& camera, const std::string& technique);

    /// The last frame's mask of a light against its truth. @param light index into the lights
    engine::Result<measure::Comparison>
    compare(const scene::CameraView& camera, std::size_t light, const truth::TruthImage& truth);

    /// What is being done, for someone who waits.
    void tell(const std::string& text) const;

    /// The level as it was last traced.
    [[nodiscard]] const trace::TraceScene& tracer() const { return tracer_; }
    [[nodiscard]] Progress& progress() { return progress_; }
    [[nodiscard]] Studio& studio() { return studio_; }
    [[nodiscard]] Level& level() { return level_; }
    [[nodiscard]] const MeasureOptions& options() const { return options_; }

private:
    [[nodiscard]] trace::VisibilityOptions visibility_options() const;

    Studio& studio_;
    Level& level_;
    const MeasureOptions& options_;
    Progress& progress_;
    trace::TraceScene tracer_;
};

} // namespace gnomon
