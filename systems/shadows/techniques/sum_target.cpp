#include "systems/shadows/techniques/sum_target.hpp"

namespace shadows {

engine::Result<void>
SumTarget::prepare(const std::string& label, const gpu::TextureDescription& sum) {
    if (texture && texture.width() == sum.width && texture.height() == sum.height
        && texture.format() == sum.format)
        return {};
    texture = gpu::Texture(label, sum);
    stencil = gpu::Texture(
        label + "/stencil",
        {.format = gpu::Format::depth32f_stencil8, .width = sum.width, .height = sum.height});
    auto target = gpu::Framebuffer::make(
        label, {.colors = {gpu::Attachment{&texture}}, .depth = gpu::Attachment{&stencil}});
    if (!target) return target.error();
    framebuffer = *std::move(target);
    return {};
}

} // namespace shadows
