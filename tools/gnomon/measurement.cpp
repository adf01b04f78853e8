#include "tools/gnomon/measurement.hpp"

#include "engine/scene/views.hpp"

#include "tools/gnomon/progress.hpp"

namespace gnomon {

Measurement::Measurement(
    Studio& studio, Level& level, const MeasureOptions& options, Progress& progress)
    : studio_(studio),
      level_(level),
      options_(options),
      progress_(progress),
      tracer_(level.world) {}

measure::Row Measurement::row(
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const std::string& technique,
    const std::string& protocol) const {
    measure::Row row;
    row.scene = level_.name;
    row.camera = camera.name;
    row.light = light.name;
    row.technique = technique;
    row.protocol = protocol;
    row.renderer = studio_.device().renderer;
    return row;
}

trace::VisibilityOptions Measurement::visibility_options() const {
    trace::VisibilityOptions options;
    options.samples = options_.truth_samples;
    return options;
}

truth::TruthImage
Measurement::truth(const scene::CameraView& camera, const scene::PlacedLight& light) {
    tracer_.update(level_.world);
    return truth::true_visibility(tracer_, camera, light, {.visibility = visibility_options()});
}

trace::VisibilityImage
Measurement::second_truth(const scene::CameraView& camera, const scene::PlacedLight& light) {
    tracer_.update(level_.world);
    return truth::second_grid(tracer_, camera, light, visibility_options());
}

engine::Result<void>
Measurement::draw(const scene::CameraView& camera, const std::string& technique) {
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

engine::Result<measure::Comparison> Measurement::compare(
    const scene::CameraView& camera, std::size_t light, const truth::TruthImage& truth) {
    const DrawnSurfaces drawn = drawn_surfaces(studio_, camera);
    const auto mask = studio_.mask(light);
    if (!mask) return mask.error();
    return make_comparison(*mask, truth, drawn, camera, studio_.lights()[light]);
}

void Measurement::tell(const std::string& text) const {
    progress_.tell(level_.name + ": " + text);
}

} // namespace gnomon
