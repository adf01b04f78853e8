#include "tests/atlas/atlas.hpp"

#include "engine/core/image.hpp"
#include "engine/scene/views.hpp"
#include "engine/trace/trace_scene.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cstdlib>

#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/row_pictures.hpp"
#include "tools/gnomon/serving.hpp"
#include "tools/gnomon/studio.hpp"
#include "tools/gnomon/text_files.hpp"

namespace atlas {

namespace {

/// Light samples of the truth where the light has an area.
constexpr int kTruthSamples = 256;
/// Frames of a stage that moves, and surface points that are followed.
constexpr int kMovingFrames = 12;
constexpr std::size_t kTrackedPoints = 20000;

engine::Result<std::size_t>
find_light(const std::vector<scene::PlacedLight>& lights, const std::string& name) {
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].name == name) return i;
    return engine::Error{fmt::format("no light '{}' in this stage", name)};
}

engine::Result<void> write_pictures(
    const std::string& stem, const engine::Image& color, const measure::Comparison& comparison) {
    const char* named = std::getenv("GNOMON_ATLAS_PICTURES");
    if (named == nullptr) return {};
    const std::filesystem::path folder(named);
    if (auto made = gnomon::make_folder(folder); !made) return made;
    const std::vector<std::pair<std::string, engine::Image>> pictures = {
        {"color", color},
        {"mask", grey(comparison.measured)},
        {"truth", grey(comparison.truth)},
        {"error", gnomon::error_image(comparison)}};
    for (const auto& [kind, image] : pictures)
        if (auto written = engine::write_png(folder / fmt::format("{}_{}.png", stem, kind), image);
            !written)
            return written;
    return {};
}

/// The mask of the light and its truth, compared.
engine::Result<measure::Comparison> compare(
    gnomon::Studio& studio, const Stage& stage, std::size_t light, const truth::TruthImage& truth) {
    const gnomon::DrawnSurfaces drawn = gnomon::drawn_surfaces(studio, stage.camera);
    const auto mask = studio.mask(light);
    if (!mask) return mask.error();
    measure::Comparison comparison =
        gnomon::make_comparison(*mask, truth, drawn, stage.camera, studio.lights()[light]);
    comparison.resolution_band_px =
        gnomon::Serving(studio.shadows(), light).bands_px(drawn, truth, stage.camera);
    return comparison;
}

truth::TruthOptions truth_options() {
    truth::TruthOptions options;
    options.visibility.samples = kTruthSamples;
    return options;
}

/// The world at one frame of a sequence.
void move_to(Stage& stage, int frame) {
    stage.move(stage, frame);
    scene::update(stage.level.world, 0.0F);
}

/// Draws a stage frame after frame, each held against its truth.
engine::Result<measure::MotionFigures>
watch(gnomon::Studio& studio, Stage& stage, std::size_t light) {
    trace::TraceScene tracer(stage.level.world);
    const auto true_image = [&](int frame) {
        move_to(stage, frame);
        tracer.update(stage.level.world);
        const auto lights = scene::placed_lights(stage.level.world);
        return truth::true_visibility(tracer, stage.camera, lights[light], truth_options());
    };
    const truth::TruthImage last = true_image(kMovingFrames - 1);
    const auto last_points = truth::surface_points(stage.camera, last.image);
    const truth::TruthImage first = true_image(0);
    const auto first_points = truth::surface_points(stage.camera, first.image);
    measure::MotionRecorder recorder(
        measure::choose_points(first_points, last_points, kTrackedPoints, 1));
    for (int frame = 0; frame < kMovingFrames; ++frame) {
        // The stage stands at its first frame already.
        const truth::TruthImage truth = frame == 0 ? first : true_image(frame);
        if (auto drawn = studio.draw(stage.level, stage.camera); !drawn) return drawn.error();
        auto compared = compare(studio, stage, light, truth);
        if (!compared) return compared.error();
        const trace::VisibilityImage second = truth::second_grid(
            tracer, stage.camera, studio.lights()[light], truth_options().visibility);
        recorder.add(
            *std::move(compared),
            truth.image.depth,
            [&](const glm::dvec3& point) { return stage.camera.project(point); },
            measure::SecondGrid{second.visibility, second.depth});
    }
    return recorder.figures();
}

} // namespace

engine::Image grey(const measure::Mask& mask) {
    engine::Image image(mask.width, mask.height, 1);
    for (std::size_t i = 0; i < image.bytes.size(); ++i)
        image.bytes[i] = static_cast<std::uint8_t>(mask.visibility[i] * 255.0F + 0.5F);
    return image;
}

engine::Result<truth::TruthImage> trace(Stage& stage) {
    scene::update(stage.level.world, 0.0F);
    const auto lights = scene::placed_lights(stage.level.world);
    const auto light = find_light(lights, stage.light);
    if (!light) return light.error();
    const trace::TraceScene tracer(stage.level.world);
    return truth::true_visibility(tracer, stage.camera, lights[*light], truth_options());
}

engine::Result<Observation>
observe(Stage& stage, const shadows::Remedies& remedies, const std::string& pictures) {
    const auto truth = trace(stage);
    if (!truth) return truth.error();
    return observe(stage, *truth, remedies, pictures);
}

engine::Result<Observation> observe(
    Stage& stage,
    const truth::TruthImage& truth,
    const shadows::Remedies& remedies,
    const std::string& pictures) {
    auto opened = gnomon::Studio::open(kPictureSize, kPictureSize);
    if (!opened) return opened.error();
    gnomon::Studio& studio = **opened;
    studio.shadows().remedies = remedies;
    if (!stage.wraps_stencil) studio.shadows().wraps_stencil = false;
    scene::update(stage.level.world, 0.0F);
    if (auto drawn = studio.draw(stage.level, stage.camera); !drawn) return drawn.error();
    if (const auto unserved = studio.shadows().unserved(); !unserved.empty())
        return engine::Error{unserved.front()};
    const engine::Image color = studio.color();
    const auto light = find_light(studio.lights(), stage.light);
    if (!light) return light.error();
    Observation seen;
    seen.counters = studio.renderer().frame().counters();
    auto compared = compare(studio, stage, *light, truth);
    if (!compared) return compared.error();
    seen.comparison = *std::move(compared);
    gnomon::find_hidden_edges(
        trace::TraceScene(stage.level.world),
        stage.camera,
        studio.lights()[*light],
        seen.comparison);
    seen.figures = measure::compare(seen.comparison);
    if (stage.move) {
        const auto watched = watch(studio, stage, *light);
        if (!watched) return watched.error();
        seen.motion = *watched;
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        return engine::Error{fmt::format("OpenGL error {:#x}", error)};
    if (auto written = write_pictures(pictures, color, seen.comparison); !written)
        return written.error();
    return seen;
}

std::vector<std::string> broken_gates(const Case& one, const Observation& seen) {
    std::vector<std::string> broken;
    for (const Gate& gate : one.gates)
        if (const double value = gate.value(seen); !(value <= gate.at_most))
            broken.push_back(
                fmt::format("{}: {:.4g}, at most {:.4g}", gate.figure, value, gate.at_most));
    return broken;
}

Gate no_false_shadow_inside() {
    return {"false shadow inside, px", [](const Observation& seen) {
                return seen.figures.interior.false_shadow_px;
            }};
}

Gate no_light_leak_inside() {
    return {"light leak inside, px", [](const Observation& seen) {
                return seen.figures.interior.light_leak_px;
            }};
}

Gate largest_error_inside(double at_most_px) {
    return {
        "largest error inside, px",
        [](const Observation& seen) { return seen.figures.interior.largest_px; },
        at_most_px};
}

Gate wrong_over_precision_floor(double at_most) {
    return {
        "wrong pixels over the precision floor",
        [](const Observation& seen) {
            const measure::Figure& over = seen.figures.over_precision_floor;
            return over.known() ? over.value() : 0.0;
        },
        at_most};
}

Gate eps_at_most(double px) {
    return {
        "eps, px of error per px of edge",
        [](const Observation& seen) {
            return seen.figures.eps_px.known() ? seen.figures.eps_px.value() : 0.0;
        },
        px};
}

std::vector<Gate> exact_shape() {
    return {
        no_false_shadow_inside(),
        no_light_leak_inside(),
        largest_error_inside(0.0),
        wrong_over_precision_floor(1.0)};
}

Stage pinned_stage(
    scene::World world,
    const scene::CameraView& camera,
    const std::string& light,
    const std::string& receiver,
    const std::string& technique) {
    Stage stage;
    stage.level.world = std::move(world);
    stage.level.shadows.scene.technique = "traced";
    stage.level.shadows.receivers[receiver].technique = technique;
    stage.camera = camera;
    stage.light = light;
    return stage;
}

} // namespace atlas
