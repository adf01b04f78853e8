#include "tools/gnomon/measuring.hpp"

#include <utility>

#include "tools/gnomon/measurement.hpp"
#include "tools/gnomon/moving_rows.hpp"
#include "tools/gnomon/still_rows.hpp"

namespace gnomon {

engine::Result<void> measure_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    measure::Report& report) {
    Measurement measurement(studio, level, options);
    if (auto drawn = measurement.draw(camera, "none"); !drawn) return drawn;
    const RowSink add = [&](measure::Row row) -> engine::Result<void> {
        report.add(std::move(row));
        return {};
    };
    const std::size_t light_count = studio.lights().size();
    for (std::size_t light = 0; light < light_count; ++light) {
        for (const std::string& protocol : options.protocols) {
            const auto measured =
                protocol == measure::kStill
                    ? measure_stills(measurement, camera, light, options.techniques, add)
                    : measure_motion(measurement, camera, light, protocol, options.techniques, add);
            if (!measured) return measured;
        }
    }
    measurement.tell("");
    return {};
}

} // namespace gnomon
