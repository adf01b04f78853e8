#include "tools/gnomon/still_rows.hpp"

#include <fmt/format.h>

#include "tools/gnomon/progress.hpp"
#include "tools/gnomon/row_pictures.hpp"
#include "tools/gnomon/serving.hpp"

namespace gnomon {

namespace {

constexpr int kStillFrames = 16;

/// Everything that rows of one light and camera share.
struct Still {
    Measurement& measurement;
    const scene::CameraView& camera;
    std::size_t light;
    const truth::TruthImage& truth;
    const engine::Image& reference; ///< the lit picture with the true masks
};

/// What only a still picture is asked: how coarse it may be where, and who drew it.
void add_serving(const Still& still, measure::Comparison& comparison, measure::Row& row) {
    Studio& studio = still.measurement.studio();
    const DrawnSurfaces drawn = drawn_surfaces(studio, still.camera);
    const Serving serving(studio.shadows(), still.light);
    comparison.resolution_band_px = serving.bands_px(drawn, still.truth, still.camera);
    find_hidden_edges(
        still.measurement.tracer(), still.camera, studio.lights()[still.light], comparison);
    if (row.technique.rfind("auto", 0) == 0) row.picked = serving.shares(drawn, comparison);
}

/// The same frame again and again: nothing may change.
engine::Result<measure::Figure> changed(const Still& still) {
    Studio& studio = still.measurement.studio();
    std::vector<measure::Mask> frames;
    for (int frame = 0; frame < kStillFrames; ++frame) {
        if (auto drawn = studio.draw(still.measurement.level(), still.camera); !drawn)
            return drawn.error();
        const auto mask = studio.mask(still.light);
        if (!mask) return mask.error();
        frames.push_back(measure::mask_from_image(*mask));
    }
    return measure::changed_px(frames);
}

/// The same renderer's picture with the true masks.
engine::Result<engine::Image>
reference_picture(Measurement& measurement, const scene::CameraView& camera) {
    if (auto drawn = measurement.draw(camera, "traced"); !drawn) return drawn.error();
    return measurement.studio().color();
}

engine::Result<void> add_times(const Still& still, measure::Row& row) {
    Studio& studio = still.measurement.studio();
    const gpu::Counters& counters = studio.renderer().frame().counters();
    row.counters = {
        .draws = static_cast<double>(counters.draws),
        .triangles = static_cast<double>(counters.triangles),
        .map_texels = static_cast<double>(counters.map_texels),
        .mask_fragments = static_cast<double>(counters.mask_fragments),
        .stencil_fragments = static_cast<double>(counters.stencil_fragments),
        .taps = static_cast<double>(counters.taps),
        .gpu_bytes = static_cast<double>(studio.shadows().gpu_bytes())};
    const TimingOptions& timing = still.measurement.options().timing;
    if (timing.frames == 0) return {};
    const auto times = time_frames(studio, timing, [&](bool with) {
        return studio.draw(still.measurement.level(), still.camera, with);
    });
    if (!times) return times.error();
    row.timing = {times->with.median_ms, times->with.p99_ms, times->without.median_ms};
    return {};
}

engine::Result<void> measure_row(const Still& still, measure::Row& row) {
    Measurement& measurement = still.measurement;
    if (auto drawn = measurement.draw(still.camera, row.technique); !drawn) {
        row.note = drawn.error().message;
        return {};
    }
    if (auto timed = add_times(still, row); !timed) return timed;
    auto comparison = measurement.compare(still.camera, still.light, still.truth);
    if (!comparison) return comparison.error();
    add_serving(still, *comparison, row);
    comparison->picture = measurement.studio().color();
    comparison->reference_picture = still.reference;
    // The traced technique is truth by its construction: agreeing with it is no copied result.
    comparison->exact_by_construction = row.technique == "traced";
    row.figures = measure::compare(*comparison);
    const auto unchanged = changed(still);
    if (!unchanged) return unchanged.error();
    row.motion = measure::MotionFigures{};
    row.motion->changed_px = *unchanged;
    return write_row_pictures(
        measurement.options().pictures, row, *comparison, comparison->picture);
}

} // namespace

engine::Result<void> measure_stills(
    Measurement& measurement,
    const scene::CameraView& camera,
    std::size_t light,
    std::span<const std::string> techniques,
    const RowSink& done) {
    const scene::PlacedLight placed = measurement.studio().lights()[light];
    measurement.tell(fmt::format("light '{}': truth", placed.name));
    const truth::TruthImage truth = measurement.truth(camera, placed);
    const auto reference = reference_picture(measurement, camera);
    if (!reference) return reference.error();
    const Still still{measurement, camera, light, truth, *reference};
    for (const std::string& technique : techniques) {
        measurement.tell(fmt::format("light '{}': {}", placed.name, technique));
        measure::Row row = measurement.row(camera, placed, technique, measure::kStill);
        // A shadow system of its own: what a row says does not depend on those before it.
        const auto shadows = measurement.studio().new_shadows();
        measurement.studio().use_shadows(shadows.get());
        const auto measured = measure_row(still, row);
        measurement.studio().use_shadows(nullptr);
        if (!measured) return measured;
        measurement.progress().add(1.0);
        if (auto taken = done(std::move(row)); !taken) return taken;
    }
    return {};
}

} // namespace gnomon
