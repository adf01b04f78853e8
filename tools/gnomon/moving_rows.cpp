#include "tools/gnomon/moving_rows.hpp"

#include "engine/scene/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tools/gnomon/motion_protocols.hpp"
#include "tools/gnomon/progress.hpp"
#include "tools/gnomon/row_pictures.hpp"
#include "tools/gnomon/scene_motion.hpp"

namespace gnomon {

namespace {

constexpr std::size_t kTrackedPoints = 20000;

/// A technique on its way through the sequence. It lives through it alone, so that what it keeps
/// from frame to frame is its own; and a twin redraws everything in every frame.
struct Run {
    measure::Row row;
    measure::MotionRecorder recorder;
    std::unique_ptr<shadows::ShadowSystem> shadows;
    std::unique_ptr<shadows::ShadowSystem> redrawn;
};

/// One frame of a sequence.
struct Moment {
    const scene::CameraView& camera;
    const truth::TruthImage& truth;
    const trace::VisibilityImage& second;
    bool last = false;
};

/// The same frame by the technique's twin.
engine::Result<void> record_lag(
    Measurement& measurement,
    const Moment& moment,
    std::size_t light,
    const measure::Comparison& as_asked,
    Run& run) {
    Studio& studio = measurement.studio();
    studio.use_shadows(run.redrawn.get());
    if (auto drawn = measurement.draw(moment.camera, run.row.technique); !drawn) return drawn;
    const auto mask = studio.mask(light);
    if (!mask) return mask.error();
    measure::Comparison redrawn = as_asked;
    redrawn.measured = measure::mask_from_image(*mask);
    run.recorder.add_lag(as_asked, redrawn, run.shadows->ages(light));
    return {};
}

engine::Result<void>
record(Measurement& measurement, const Moment& moment, std::size_t light, Run& run) {
    Studio& studio = measurement.studio();
    studio.use_shadows(run.shadows.get());
    if (auto drawn = measurement.draw(moment.camera, run.row.technique); !drawn) {
        run.row.note = drawn.error().message;
        return {};
    }
    auto comparison = measurement.compare(moment.camera, light, moment.truth);
    if (!comparison) return comparison.error();
    if (moment.last)
        if (auto written = write_row_pictures(
                measurement.options().pictures, run.row, *comparison, studio.color());
            !written)
            return written;
    if (auto lagged = record_lag(measurement, moment, light, *comparison, run); !lagged)
        return lagged;
    run.recorder.add(
        *std::move(comparison),
        moment.truth.image.depth,
        [&](const glm::dvec3& point) { return moment.camera.project(point); },
        measure::SecondGrid{moment.second.visibility, moment.second.depth});
    return {};
}

/// Everything that moves, frame after frame.
class Sequence {
public:
    Sequence(Level& level, const std::string& protocol, const scene::CameraView& start, int count)
        : level_(level),
          protocol_(protocol),
          start_(start),
          count_(count),
          motion_(level.world, protocol, start) {}

    /// Moves the world on to a frame. @pre frames are asked for in order, from 0
    scene::CameraView pose(int frame) {
        if (protocol_ == "play" && frame > 0) advance(level_, static_cast<float>(kFrameSeconds));
        if (motion_.moves_anything()) motion_.pose(frame);
        return camera(frame);
    }
    [[nodiscard]] scene::CameraView camera(int frame) const {
        return camera_at(protocol_, start_, frame, count_);
    }

private:
    Level& level_;
    std::string protocol_;
    scene::CameraView start_;
    int count_;
    SceneMotion motion_;
};

std::vector<Run> make_runs(
    Measurement& measurement,
    const scene::CameraView& start,
    const scene::PlacedLight& light,
    const std::string& protocol,
    std::span<const std::string> techniques,
    const measure::TrackPoints& points) {
    std::vector<Run> runs;
    for (const std::string& technique : techniques) {
        Run run{
            measurement.row(start, light, technique, protocol),
            measure::MotionRecorder(points, !find_protocol(protocol).moves_camera),
            measurement.studio().new_shadows(),
            measurement.studio().new_shadows()};
        run.row.settings = fmt::format("{} frames", measurement.options().moving_frames);
        run.redrawn->always_refresh = true;
        runs.push_back(std::move(run));
    }
    return runs;
}

/// All frames, with the level as the measurement has it.
engine::Result<void> run_through(
    Measurement& measurement,
    const scene::CameraView& start,
    std::uint32_t light_id,
    const std::string& protocol,
    std::vector<Run>& runs) {
    const int frame_count = measurement.options().moving_frames;
    Sequence sequence(measurement.level(), protocol, start, frame_count);
    for (int frame = 0; frame < frame_count; ++frame) {
        const scene::CameraView camera = sequence.pose(frame);
        const auto lights = scene::placed_lights(measurement.level().world);
        const auto placed =
            std::find_if(lights.begin(), lights.end(), [&](const scene::PlacedLight& candidate) {
                return candidate.id == light_id;
            });
        if (placed == lights.end()) {
            for (Run& run : runs)
                run.row.note = fmt::format("the light is off in frame {}", frame);
            return {};
        }
        const auto light = static_cast<std::size_t>(placed - lights.begin());
        measurement.tell(
            fmt::format("light '{}': {} {}/{}", placed->name, protocol, frame + 1, frame_count));
        const truth::TruthImage truth = measurement.truth(camera, *placed);
        const trace::VisibilityImage second = measurement.second_truth(camera, *placed);
        const Moment moment{camera, truth, second, frame + 1 == frame_count};
        for (Run& run : runs)
            if (run.row.note.empty())
                if (auto recorded = record(measurement, moment, light, run); !recorded)
                    return recorded;
        measurement.progress().add(static_cast<double>(runs.size()));
    }
    return {};
}

/// The same with a level of its own, from its beginning: what a script did cannot be undone.
engine::Result<void> play_through(
    Measurement& measurement,
    const scene::CameraView& start,
    std::uint32_t light_id,
    std::vector<Run>& runs) {
    auto level = load_level(measurement.level().file);
    if (!level) return level.error();
    level->shadows = measurement.level().shadows;
    level->exposure = measurement.level().exposure;
    Measurement playing(
        measurement.studio(), *level, measurement.options(), measurement.progress());
    return run_through(playing, start, light_id, "play", runs);
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
    const scene::PlacedLight placed = scene::placed_lights(measurement.level().world)[light];
    const scene::CameraView end = camera_at(protocol, start, frame_count - 1, frame_count);
    const auto points = measure::choose_points(
        truth::surface_points(start, measurement.truth(start, placed).image),
        truth::surface_points(end, measurement.truth(end, placed).image),
        kTrackedPoints,
        1);
    std::vector<Run> runs = make_runs(measurement, start, placed, protocol, techniques, points);
    const auto through = protocol == "play"
                             ? play_through(measurement, start, placed.id, runs)
                             : run_through(measurement, start, placed.id, protocol, runs);
    measurement.studio().use_shadows(nullptr);
    if (!through) return through;
    for (Run& run : runs) {
        if (run.row.note.empty()) run.row.motion = run.recorder.figures();
        if (auto taken = done(std::move(run.row)); !taken) return taken;
    }
    return {};
}

} // namespace gnomon
