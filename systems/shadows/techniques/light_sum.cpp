#include "systems/shadows/techniques/light_sum.hpp"

#include "systems/shadows/techniques/rectangles.hpp"

#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

namespace shadows {

engine::Result<void>
LightSum::prepare(gpu::ShaderLibrary& shaders, const std::string& label, const glm::ivec2& size) {
    const auto program = shaders.graphics("gpu/fullscreen.vert", "shadows/light_sum.frag");
    if (!program) return program.error();
    program_ = *program;
    if (texture_ && texture_.width() == size.x && texture_.height() == size.y) return {};
    texture_ =
        gpu::Texture(label, {.format = gpu::Format::rg32f, .width = size.x, .height = size.y});
    auto target = gpu::Framebuffer::make(label, {.colors = {gpu::Attachment{&texture_}}});
    if (!target) return target.error();
    target_ = *std::move(target);
    return {};
}

void LightSum::compose(gpu::Frame& frame, std::span<const gpu::Rect> areas) const {
    gpu::RenderState state = gpu::kScreenState;
    state.blend = gpu::Blend::min;
    texture_.bind(UNIT_VISIBILITY);
    for (const gpu::Rect& area : areas) {
        state.scissor = area;
        frame.state(state);
        frame.draw_fullscreen(*program_);
        frame.counters().mask_fragments += pixels(area);
    }
}

} // namespace shadows
