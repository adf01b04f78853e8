#include "tools/gnomon/studio.hpp"

#include "engine/gpu/probe.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/scene/views.hpp"

#include <limits>

namespace gnomon {

namespace {

/// As include/gbuffer.glsl packs it.
constexpr std::uint32_t kReceiverMask = scene::kMaxReceivers - 1;

} // namespace

Studio::Studio(std::unique_ptr<gpu::Context> context)
    : context_(std::move(context)),
      renderer_(shadows::shader_folders()) {
    shadows_.wraps_stencil = gpu::probe_driver().wraps_stencil;
}

engine::Result<std::unique_ptr<Studio>> Studio::open(int width, int height) {
    auto context = gpu::make_headless_context();
    if (!context) return context.error();
    std::unique_ptr<Studio> studio(new Studio(*std::move(context)));
    studio->color_ =
        gpu::Texture("picture", {.format = gpu::Format::rgba8, .width = width, .height = height});
    auto target = gpu::Framebuffer::make("picture", {.colors = {{&studio->color_}}});
    if (!target) return target.error();
    studio->target_ = *std::move(target);
    return studio;
}

engine::Result<void>
Studio::draw(const Level& level, const scene::CameraView& camera, bool with_shadows) {
    lights_ = scene::placed_lights(level.world);
    shadows_.settings = level.shadows;
    const auto drawn = renderer_.draw(
        level.world,
        camera,
        lights_,
        with_shadows ? &shadows_ : nullptr,
        target_,
        {.exposure = level.exposure});
    context_->finish();
    return drawn;
}

engine::Image Studio::color() const {
    return gpu::read_image(color_);
}

std::vector<std::uint32_t> Studio::receiver_ids() const {
    const auto surface = gpu::read_uint_pairs(renderer_.gbuffer().surface());
    std::vector<std::uint32_t> ids;
    ids.reserve(surface.values.size());
    for (const glm::uvec2& texel : surface.values)
        ids.push_back(texel.x & kReceiverMask);
    return ids;
}

std::vector<float> Studio::view_depth(const scene::CameraView& camera) const {
    std::vector<float> depth = gpu::read_depth(renderer_.gbuffer().depth()).values;
    for (float& value : depth)
        value = value > 0.0F ? camera.near / value : std::numeric_limits<float>::infinity();
    return depth;
}

} // namespace gnomon
