#include "tools/gnomon/measuring.hpp"

#include "engine/core/image.hpp"
#include "engine/scene/views.hpp"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/serving.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

constexpr double kWalkSpeed = 1.4; // m/s
constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr double kTurnPerFrame = std::numbers::pi / 180.0;
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
        return truth::true_visibility(tracer_, camera, light, truth_options());
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

    /// What only a still picture is asked: how coarse it may be where, and who drew it.
    void add_serving(
        const scene::CameraView& camera,
        std::size_t light,
        const truth::TruthImage& truth,
        measure::Comparison& comparison,
        measure::Row& row) {
        const DrawnSurfaces drawn = drawn_surfaces(studio_, camera);
        const Serving serving(studio_.shadows(), light);
        comparison.resolution_band_px = serving.bands_px(drawn, truth, camera);
        find_hidden_edges(camera, light, comparison);
        if (row.technique.rfind("auto", 0) == 0) row.picked = serving.shares(drawn, comparison);
    }

    /// The camera stays where it is.
    engine::Result<std::vector<measure::Row>>
    stills(const scene::CameraView& camera, std::size_t light);
    /// The camera walks or turns.
    engine::Result<std::vector<measure::Row>>
    moving(const scene::CameraView& start, std::size_t light, const std::string& protocol);

private:
    engine::Result<measure::Row> still(
        const scene::CameraView& camera,
        std::size_t light,
        const std::string& technique,
        const truth::TruthImage& truth);
    [[nodiscard]] truth::TruthOptions truth_options() const {
        truth::TruthOptions options;
        options.visibility.samples = options_.truth_samples;
        return options;
    }
    void find_hidden_edges(
        const scene::CameraView& camera, std::size_t light, measure::Comparison& comparison) const;
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
    add_serving(camera, light, truth, *comparison, row);
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

/// Looks closer at what would count as a wrong shape. Where very much would, it is one.
void Measurement::find_hidden_edges(
    const scene::CameraView& camera, std::size_t light, measure::Comparison& comparison) const {
    constexpr std::ptrdiff_t kMostPixels = 4096;
    const std::vector<std::uint8_t> far = measure::far_errors(comparison);
    if (std::count(far.begin(), far.end(), 1) > kMostPixels) return;
    comparison.hidden_edge.assign(far.size(), 0);
    trace::for_each_row(camera.height, 0, nullptr, [&](int y) {
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t pixel = comparison.truth.index(x, y);
            if (far[pixel] == 0) continue;
            const bool found = truth::edge_near(
                tracer_,
                camera,
                studio_.lights()[light],
                {x + 0.5, y + 0.5},
                measure::lit(comparison.truth.visibility[pixel]),
                static_cast<double>(comparison.resolution_band_px[pixel]),
                static_cast<double>(measure::kGrazingCosine));
            comparison.hidden_edge[pixel] = found ? 1 : 0;
        }
    });
}

engine::Result<std::vector<measure::Row>>
Measurement::stills(const scene::CameraView& camera, std::size_t light) {
    const scene::PlacedLight placed = studio_.lights()[light];
    progress(fmt::format("{}: light '{}': truth", level_.name, placed.name));
    const truth::TruthImage truth = this->truth(camera, placed);
    std::vector<measure::Row> rows;
    for (const std::string& technique : options_.techniques) {
        progress(fmt::format("{}: light '{}': {}", level_.name, placed.name, technique));
        auto row = still(camera, light, technique, truth);
        if (!row) return row.error();
        rows.push_back(*std::move(row));
    }
    return rows;
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

/// Along the view, on the level.
scene::CameraView walked(scene::CameraView camera, int frame) {
    glm::dvec3 forward = -glm::dvec3(camera.world_from_view[2]);
    forward.y = 0.0;
    if (glm::length(forward) < 1e-6)
        forward = glm::dvec3(camera.world_from_view[1]); // looks straight down or up
    camera.position += glm::normalize(forward) * (kWalkSpeed * kFrameSeconds * frame);
    return camera;
}

/// To the left.
scene::CameraView turned(scene::CameraView camera, int frame) {
    const glm::dmat4 turn =
        glm::rotate(glm::dmat4(1.0), kTurnPerFrame * frame, glm::dvec3(0.0, 1.0, 0.0));
    camera.world_from_view = glm::mat3(glm::dmat3(turn) * glm::dmat3(camera.world_from_view));
    return camera;
}

engine::Result<std::vector<measure::Row>> Measurement::moving(
    const scene::CameraView& start, std::size_t light, const std::string& protocol) {
    const auto camera_at = [&](int frame) {
        return protocol == "yaw" ? turned(start, frame) : walked(start, frame);
    };
    const scene::PlacedLight placed = studio_.lights()[light];
    const scene::CameraView end = camera_at(options_.moving_frames - 1);
    const auto points = measure::choose_points(
        surface_points(start, truth(start, placed).image),
        surface_points(end, truth(end, placed).image),
        kTrackedPoints,
        1);
    std::vector<measure::Row> rows;
    std::vector<measure::MotionRecorder> recorders;
    for (const std::string& technique : options_.techniques) {
        rows.push_back(row(start, placed, technique));
        rows.back().settings = fmt::format("{} of {} frames", protocol, options_.moving_frames);
        recorders.emplace_back(points);
    }
    for (int frame = 0; frame < options_.moving_frames; ++frame) {
        progress(fmt::format(
            "{}: light '{}': {} {}/{}",
            level_.name,
            placed.name,
            protocol,
            frame + 1,
            options_.moving_frames));
        const scene::CameraView camera = camera_at(frame);
        const truth::TruthImage true_image = truth(camera, placed);
        const trace::VisibilityImage second =
            truth::second_grid(tracer_, camera, placed, truth_options().visibility);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!rows[i].note.empty()) continue;
            if (auto drawn = draw(camera, options_.techniques[i]); !drawn) {
                rows[i].note = drawn.error().message;
                continue;
            }
            auto comparison = compare(camera, light, true_image);
            if (!comparison) return comparison.error();
            recorders[i].add(
                *std::move(comparison),
                true_image.image.depth,
                [&](const glm::dvec3& point) { return camera.project(point); },
                measure::SecondGrid{second.visibility, second.depth});
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
        for (const std::string& protocol : options.protocols) {
            auto rows = protocol == "still" ? measurement.stills(camera, light)
                                            : measurement.moving(camera, light, protocol);
            if (!rows) return rows.error();
            for (measure::Row& row : *rows)
                report.add(std::move(row));
        }
    }
    progress("");
    return {};
}

} // namespace gnomon
