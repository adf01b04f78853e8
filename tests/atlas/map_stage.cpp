#include "tests/atlas/map_stage.hpp"

namespace atlas {

Stage one_map(
    test_support::WorldBuilder& builder,
    const scene::CameraView& camera,
    const std::string& light,
    const std::string& receiver,
    const std::string& technique,
    int size) {
    Stage stage = pinned_stage(std::move(builder.world), camera, light, receiver, technique);
    stage.level.shadows.scene.map_size = size;
    stage.level.shadows.scene.cascades = 1;
    return stage;
}

Gate false_shadow_at_most(double px) {
    Gate gate = no_false_shadow_inside();
    gate.at_most = px;
    return gate;
}

Gate light_leak_at_most(double px) {
    Gate gate = no_light_leak_inside();
    gate.at_most = px;
    return gate;
}

Gate dimmed_at_most(double px, double visibility) {
    return {
        "lit pixels dimmed, px",
        [visibility](const Observation& seen) {
            const measure::Comparison& c = seen.comparison;
            double dimmed = 0.0;
            for (std::size_t i = 0; i < c.kind.size(); ++i)
                if (c.kind[i] == measure::PixelKind::valid && c.truth.visibility[i] == 1.0F
                    && static_cast<double>(c.measured.visibility[i]) < visibility)
                    ++dimmed;
            return dimmed;
        },
        px};
}

std::vector<Gate> right_beyond_texels() {
    const auto value = [](const measure::Figure& figure) {
        return figure.known() ? figure.value() : 0.0;
    };
    return {
        {"false shadow beyond a texel's reach, px",
         [value](const Observation& seen) { return value(seen.figures.far_false_shadow_px); }},
        {"light leak beyond a texel's reach, px",
         [value](const Observation& seen) { return value(seen.figures.far_light_leak_px); }}};
}

Gate lit_share_of_shadow(double at_most) {
    return {
        "lit share of the true shadow",
        [](const Observation& seen) {
            const measure::Comparison& c = seen.comparison;
            double dark = 0.0;
            double lit = 0.0;
            for (std::size_t i = 0; i < c.kind.size(); ++i) {
                if (c.kind[i] != measure::PixelKind::valid) continue;
                if (measure::lit(c.truth.visibility[i])) continue;
                dark += 1.0;
                lit += measure::lit(c.measured.visibility[i]) ? 1.0 : 0.0;
            }
            return dark > 0.0 ? lit / dark : 0.0;
        },
        at_most};
}

} // namespace atlas
