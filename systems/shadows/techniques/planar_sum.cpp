#include "systems/shadows/techniques/planar_sum.hpp"

#include <cmath>

namespace shadows {

engine::Result<void>
PlanarSum::prepare(const std::string& label, const glm::ivec2& size, const Remedies& remedies) {
    remedies_ = remedies;
    const gpu::Format format =
        remedies_.on(Remedy::planar_float_sum) ? gpu::Format::r32f : gpu::Format::r8;
    // Read as a texture of a plane it is filtered, and nothing is dark beyond it.
    return sum_.prepare(
        label,
        {.format = format,
         .width = size.x,
         .height = size.y,
         .sampling = {
             .min = gpu::Filter::linear,
             .mag = gpu::Filter::linear,
             .wrap = gpu::Wrap::clamp_to_border}});
}

float PlanarSum::added(const PlanarSample& sample, std::size_t count) const {
    if (remedies_.on(Remedy::planar_float_sum)) return static_cast<float>(sample.weight);
    return std::round(255.0F / static_cast<float>(count)) / 255.0F;
}

gpu::RenderState PlanarSum::adding_state(const gpu::Rect& area, std::uint8_t mark) const {
    gpu::RenderState state;
    state.depth_write = false;
    state.depth_test = gpu::Compare::always;
    state.scissor = area;
    state.clip_distances = 2;
    state.blend = gpu::Blend::add;
    // Marks fall from sample to sample: what this one has darkened is as low as its mark, and what
    // is no receiver is lower than all.
    const bool once = remedies_.on(Remedy::planar_once_per_sample);
    state.stencil = gpu::Stencil::both(
        {.test = gpu::Compare::less,
         .on_pass = once ? gpu::StencilOp::replace : gpu::StencilOp::keep,
         .reference = mark});
    return state;
}

gpu::RenderState PlanarSum::darkest_state(const gpu::Rect& area) const {
    gpu::RenderState state = adding_state(area, 0);
    const bool darkest = remedies_.on(Remedy::planar_plateau_darkest);
    state.blend = darkest ? gpu::Blend::max : gpu::Blend::add;
    state.stencil = gpu::Stencil::both({.test = gpu::Compare::less, .reference = 0});
    return state;
}

} // namespace shadows
