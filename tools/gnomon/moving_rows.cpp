#include "tools/gnomon/moving_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tools/gnomon/motion_protocols.hpp"
#include "tools/gnomon/row_pictures.hpp"

namespace gnomon {

namespace {

constexpr std::size_t kTrackedPoints = 20000;

/// Where the true surfaces of a frame are, for choosing points to follow.
std::vector<glm::dvec3>
surface_points(const scene::CameraView& camera, const trace::VisibilityImage& image) {
    std::vector<glm::dvec3> points;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto depth = static_cast<double>(image.depth[image.index(x, y)]);
            if (std::isfinite(depth))
                points.push_back(camera.position + camera.ray_direction(x + 0.5, y + 0.5) * depth);
        }
    return points;
}

/// A technique on its way through the sequence.
struct Run {
    measure::Row row;
    measure::MotionRecorder recorder;
};

/// One frame of a sequence.
struct Moment {
    const scene::CameraView& camera;
    const truth::TruthImage& truth;
    const trace::VisibilityImage& second;
    bool last = false;
};

engine::Result<void>
record(Measurement& measurement, const Moment& moment, std::size_t light, Run& run) {
    if (auto drawn = measurement.draw(moment.camera, run.row.technique); !drawn) {
        run.row.note = drawn.error().message;
        return {};
    }
    auto comparison = measurement.compare(moment.camera, light, moment.truth);
    if (!comparison) return comparison.error();
    if (moment.last)
        if (auto written = write_row_pictures(
                measurement.options().pictures, run.row, *comparison, measurement.studio().color());
            !written)
            return written;
    run.recorder.add(
        *std::move(comparison),
        moment.truth.image.depth,
        [&](const glm::dvec3& point) { return moment.camera.project(point); },
        measure::SecondGrid{moment.second.visibility, moment.second.depth});
    return {};
}

} // namespace

engine::Result<void> measure_motion(
    Measurement& measurement,
    const scene::CameraView& start,
    std::size_t light,
    const std::string& protocol,
    std::span<const std::string> techniques,
    const RowSink& done) {
    const int frame_count = measurement.options().moving_frames;
    const scene::PlacedLight placed = measurement.studio().lights()[light];
    const scene::CameraView end = camera_at(protocol, start, frame_count - 1, frame_count);
    const auto points = measure::choose_points(
        surface_points(start, measurement.truth(start, placed).image),
        surface_points(end, measurement.truth(end, placed).image),
        kTrackedPoints,
        1);
    std::vector<Run> runs;
    for (const std::string& technique : techniques) {
        runs.push_back(
            {measurement.row(start, placed, technique, protocol), measure::MotionRecorder(points)});
        runs.back().row.settings = fmt::format("{} frames", frame_count);
    }
    for (int frame = 0; frame < frame_count; ++frame) {
        measurement.tell(
            fmt::format("light '{}': {} {}/{}", placed.name, protocol, frame + 1, frame_count));
        const scene::CameraView camera = camera_at(protocol, start, frame, frame_count);
        const truth::TruthImage truth = measurement.truth(camera, placed);
        const trace::VisibilityImage second = measurement.second_truth(camera, placed);
        const Moment moment{camera, truth, second, frame + 1 == frame_count};
        for (Run& run : runs)
            if (run.row.note.empty())
                if (auto recorded = record(measurement, moment, light, run); !recorded)
                    return recorded;
    }
    for (Run& run : runs) {
        if (run.row.note.empty()) run.row.motion = run.recorder.figures();
        if (auto taken = done(std::move(run.row)); !taken) return taken;
    }
    return {};
}

} // namespace gnomon
