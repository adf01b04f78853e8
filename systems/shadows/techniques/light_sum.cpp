#include "systems/shadows/techniques/light_sum.hpp"

#include "engine/core/check.hpp"
#include "systems/shadows/techniques/rectangles.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

namespace shadows {

engine::Result<void> LightSum::prepare(
    gpu::ShaderLibrary& shaders,
    const std::string& label,
    const glm::ivec2& size,
    const std::vector<LightView>& points) {
    CHECK_LE(points.size(), 255U);
    points_ = points;
    const auto program = shaders.graphics(
        "shadows/screen_ray.vert",
        "shadows/light_sum.frag",
        {fmt::format("POINTS={}", points.size())});
    if (!program) return program.error();
    program_ = *program;
    return sum_.prepare(label, {.format = gpu::Format::r32f, .width = size.x, .height = size.y});
}

gpu::RenderState LightSum::adding(std::size_t point) const {
    gpu::RenderState state = gpu::kScreenState;
    state.blend = gpu::Blend::add;
    state.stencil = gpu::Stencil::both(
        {.test = gpu::Compare::not_equal,
         .on_pass = gpu::StencilOp::replace,
         .reference = static_cast<std::uint8_t>(point + 1)});
    return state;
}

void LightSum::compose(
    gpu::Frame& frame, const scene::CameraView& camera, const gpu::Rect& area) const {
    std::vector<glm::vec4> points;
    for (const LightView& point : points_)
        points.push_back(
            point.light.kind == scene::LightKind::directional
                ? glm::vec4(-point.direction, 0.0F)
                : glm::vec4(glm::vec3(point.position - camera.position), 1.0F));
    program_->set("points", std::span<const glm::vec4>(points));
    gpu::RenderState state = gpu::kScreenState;
    state.blend = gpu::Blend::min;
    state.scissor = area;
    sum_.texture.bind(UNIT_VISIBILITY);
    frame.state(state);
    frame.draw_fullscreen(*program_);
    frame.counters().mask_fragments += pixels(area);
}

} // namespace shadows
