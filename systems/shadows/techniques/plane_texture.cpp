#include "systems/shadows/techniques/plane_texture.hpp"

#include "engine/gpu/pass.hpp"
#include "systems/shadows/techniques/rectangles.hpp"

#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

namespace shadows {

engine::Result<void> PlaneTexture::prepare(
    const std::string& label,
    const PlaneRectangle& rectangle,
    const glm::ivec2& size,
    const Remedies& remedies) {
    label_ = label;
    rectangle_ = rectangle;
    return sum_.prepare(label, size, remedies);
}

void PlaneTexture::draw(
    gpu::Frame& frame,
    const PlanarDraws& draws,
    const PlanarDraws::Runs& runs,
    std::span<const PlanarSample> samples) const {
    const gpu::Framebuffer& target = sum_.target();
    const gpu::ScopedPass pass(
        frame,
        label_,
        target,
        {.color = glm::vec4(0.0F), .stencil = static_cast<int>(PlanarSum::kOpen)});
    sum_.add(
        frame,
        draws,
        runs,
        samples,
        texture_from_plane(rectangle_, draws.origin()),
        target.whole(),
        [&] { gpu::clear_target(frame, target, {.stencil = static_cast<int>(PlanarSum::kOpen)}); });
    frame.counters().map_texels += pixels(target.whole()) * samples.size();
}

void PlaneTexture::look_up(
    gpu::Frame& frame,
    const gpu::Program& program,
    const scene::CameraView& camera,
    std::uint32_t receiver,
    gpu::RenderState state) const {
    const glm::dvec2 eye = rectangle_.place(camera.position);
    program.set("receiver", receiver);
    program.set(
        "across",
        glm::vec4(glm::vec3(rectangle_.right / rectangle_.size.x), static_cast<float>(eye.x)));
    program.set(
        "along",
        glm::vec4(glm::vec3(rectangle_.up / rectangle_.size.y), static_cast<float>(eye.y)));
    sum_.texture().bind(UNIT_VISIBILITY);
    frame.state(state);
    frame.draw_fullscreen(program);
    const auto touched = pixels(state.scissor.value_or(gpu::Rect{}));
    frame.counters().mask_fragments += touched;
    frame.counters().taps += touched;
}

} // namespace shadows
