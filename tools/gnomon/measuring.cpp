#include "tools/gnomon/measuring.hpp"

#include "engine/core/image.hpp"
#include "engine/scene/views.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

constexpr double kWalkSpeed = 1.4; // m/s
constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr int kStillFrames = 16;
constexpr std::size_t kTrackedPoints = 20000;

void progress(const std::string& text) {
    fmt::print(stderr, "\r\x1b[K{}", text);
    std::fflush(stderr);
}

/// Everything one level's measurement works with.
class Measurement {
public:
    Measurement(Studio& studio, Level& level, const MeasureOptions& options)
        : studio_(studio),
          level_(level),
          options_(options),
          tracer_(level.world) {}

    /// A row for a light and a technique, with everything but figures.
    measure::Row
    row(const scene::CameraView& camera,
        const scene::PlacedLight& light,
        const std::string& technique) {
        measure::Row row;
        row.scene = level_.name;
        row.camera = camera.name;
        row.light = light.name;
        row.technique = technique;
        row.renderer = studio_.device().renderer;
        return row;
    }

    truth::TruthImage
    truth(const scene::CameraView& camera, const scene::PlacedLight& light) const {
        truth::TruthOptions options;
        options.visibility.samples = options_.truth_samples;
        return truth::true_visibility(tracer_, camera, light, options);
    }

    /// Draws a frame with a technique. Why it cannot, when it cannot.
    engine::Result<void> draw(const scene::CameraView& camera, const std::string& technique) {
        const auto asked = options_from_word(technique, studio_.shadows().techniques());
        if (!asked) return asked.error();
        override_wishes(level_.shadows, *asked);
        const auto lights = scene::placed_lights(level_.world);
        if (auto missing = missing_technique(*asked, lights, studio_.shadows().techniques()))
            return engine::Error{*missing};
        if (auto drawn = studio_.draw(level_, camera); !drawn) return drawn;
        if (const auto unserved = studio_.shadows().unserved(); !unserved.empty())
            return engine::Error{unserved.front()};
        return {};
    }

    engine::Result<measure::Comparison>
    compare(const scene::CameraView& camera, std::size_t light, const truth::TruthImage& truth) {
        const DrawnSurfaces drawn = drawn_surfaces(studio_, camera);
        const auto mask = studio_.mask(light);
        if (!mask) return mask.error();
        return make_comparison(*mask, truth, drawn, camera, studio_.lights()[light]);
    }

    engine::Result<measure::Row> still(
        const scene::CameraView& camera,
        std::size_t light,
        const std::string& technique,
        const truth::TruthImage& truth);

    engine::Result<std::vector<measure::Row>>
    walk(const scene::CameraView& start, std::size_t light);

private:
    engine::Result<measure::Figure> changed(const scene::CameraView& camera, std::size_t light);
    engine::Result<void>
    add_luminance(const scene::CameraView& camera, measure::Comparison& comparison);
    engine::Result<void> add_times(const scene::CameraView& camera, measure::Row& row);
    engine::Result<void>
    write_pictures(const measure::Row& row, const measure::Comparison& comparison) const;

    Studio& studio_;
    Level& level_;
    const MeasureOptions& options_;
    trace::TraceScene tracer_;
};

/// The same frame again and again: nothing may change.
engine::Result<measure::Figure>
Measurement::changed(const scene::CameraView& camera, std::size_t light) {
    std::vector<measure::Mask> frames;
    for (int frame = 0; frame < kStillFrames; ++frame) {
        if (auto drawn = studio_.draw(level_, camera); !drawn) return drawn.error();
        const auto mask = studio_.mask(light);
        if (!mask) return mask.error();
        frames.push_back(measure::mask_from_image(*mask));
    }
    return measure::changed_px(frames);
}

/// The lit pictures of the technique and of the same renderer with the true masks.
engine::Result<void>
Measurement::add_luminance(const scene::CameraView& camera, measure::Comparison& comparison) {
    comparison.luminance = display_luminance(studio_.color());
    const auto overriding = level_.shadows.overriding;
    if (auto drawn = draw(camera, "traced"); !drawn) return drawn;
    comparison.reference_luminance = display_luminance(studio_.color());
    level_.shadows.overriding = overriding;
    return studio_.draw(level_, camera);
}

engine::Result<void> Measurement::add_times(const scene::CameraView& camera, measure::Row& row) {
    const gpu::Counters& counters = studio_.renderer().frame().counters();
    row.counters = {
        .draws = static_cast<double>(counters.draws),
        .triangles = static_cast<double>(counters.triangles),
        .map_texels = static_cast<double>(counters.map_texels),
        .mask_fragments = static_cast<double>(counters.mask_fragments),
        .stencil_fragments = static_cast<double>(counters.stencil_fragments),
        .taps = static_cast<double>(counters.taps),
        .gpu_bytes = static_cast<double>(gpu::device_bytes())};
    if (options_.timing.frames == 0) return {};
    const auto times = time_frames(
        studio_, options_.timing, [&](bool with) { return studio_.draw(level_, camera, with); });
    if (!times) return times.error();
    row.timing = {times->with.median_ms, times->with.p99_ms, times->without.median_ms};
    return {};
}

engine::Result<void>
Measurement::write_pictures(const measure::Row& row, const measure::Comparison& comparison) const {
    const std::string stem = fmt::format(
        "{}_{}_{}", file_word(row.scene), file_word(row.light), file_word(row.technique));
    return engine::write_png(options_.pictures / (stem + "_error.png"), error_image(comparison));
}

engine::Result<measure::Row> Measurement::still(
    const scene::CameraView& camera,
    std::size_t light,
    const std::string& technique,
    const truth::TruthImage& truth) {
    measure::Row row = this->row(camera, studio_.lights()[light], technique);
    if (auto drawn = draw(camera, technique); !drawn) {
        row.note = drawn.error().message;
        return row;
    }
    if (auto timed = add_times(camera, row); !timed) return timed.error();
    auto comparison = compare(camera, light, truth);
    if (!comparison) return comparison.error();
    if (auto lit = add_luminance(camera, *comparison); !lit) return lit.error();
    // The traced technique is truth by its construction: agreeing with it is no copied result.
    comparison->exact_by_construction = technique == "traced";
    row.figures = measure::compare(*comparison);
    const auto unchanged = changed(camera, light);
    if (!unchanged) return unchanged.error();
    row.motion = measure::MotionFigures{};
    row.motion->changed_px = *unchanged;
    if (auto written = write_pictures(row, *comparison); !written) return written.error();
    return row;
}

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

scene::CameraView walked(scene::CameraView camera, int frame) {
    glm::dvec3 forward = -glm::dvec3(camera.world_from_view[2]);
    forward.y = 0.0;
    if (glm::length(forward) < 1e-6)
        forward = glm::dvec3(camera.world_from_view[1]); // looks straight down or up
    camera.position += glm::normalize(forward) * (kWalkSpeed * kFrameSeconds * frame);
    return camera;
}

engine::Result<std::vector<measure::Row>>
Measurement::walk(const scene::CameraView& start, std::size_t light) {
    const scene::PlacedLight placed = studio_.lights()[light];
    const scene::CameraView end = walked(start, options_.walk_frames - 1);
    const auto points = measure::choose_points(
        surface_points(start, truth(start, placed).image),
        surface_points(end, truth(end, placed).image),
        kTrackedPoints,
        1);
    std::vector<measure::Row> rows;
    std::vector<measure::MotionRecorder> recorders;
    for (const std::string& technique : options_.techniques) {
        rows.push_back(row(start, placed, technique));
        rows.back().settings = fmt::format("walk of {} frames", options_.walk_frames);
        recorders.emplace_back(points);
    }
    for (int frame = 0; frame < options_.walk_frames; ++frame) {
        progress(fmt::format(
            "{}: light '{}': walk {}/{}",
            level_.name,
            placed.name,
            frame + 1,
            options_.walk_frames));
        const scene::CameraView camera = walked(start, frame);
        const truth::TruthImage true_image = truth(camera, placed);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!rows[i].note.empty()) continue;
            if (auto drawn = draw(camera, options_.techniques[i]); !drawn) {
                rows[i].note = drawn.error().message;
                continue;
            }
            auto comparison = compare(camera, light, true_image);
            if (!comparison) return comparison.error();
            recorders[i].add(
                *std::move(comparison), true_image.image.depth, [&](const glm::dvec3& point) {
                    return camera.project(point);
                });
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].note.empty()) rows[i].motion = recorders[i].figures();
    return rows;
}

} // namespace

engine::Result<void> measure_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    measure::Report& report) {
    Measurement measurement(studio, level, options);
    if (auto drawn = measurement.draw(camera, "none"); !drawn) return drawn;
    const std::size_t light_count = studio.lights().size();
    for (std::size_t light = 0; light < light_count; ++light) {
        const scene::PlacedLight placed = studio.lights()[light];
        if (options.protocol != "walk") {
            progress(fmt::format("{}: light '{}': truth", level.name, placed.name));
            const truth::TruthImage truth = measurement.truth(camera, placed);
            for (const std::string& technique : options.techniques) {
                progress(fmt::format("{}: light '{}': {}", level.name, placed.name, technique));
                auto row = measurement.still(camera, light, technique, truth);
                if (!row) return row.error();
                report.add(*std::move(row));
            }
        }
        if (options.protocol != "still") {
            auto rows = measurement.walk(camera, light);
            if (!rows) return rows.error();
            for (measure::Row& row : *rows)
                report.add(std::move(row));
        }
    }
    progress("");
    return {};
}

} // namespace gnomon
