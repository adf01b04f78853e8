#include "tools/gnomon/studio.hpp"

#include "engine/gpu/probe.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/scene/views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {

namespace {

/// As include/gbuffer.glsl packs it.
constexpr std::uint32_t kReceiverMask = scene::kMaxReceivers - 1;

/// surface_direction(), made unit length.
glm::vec3 normal_of(const glm::uvec2& texel) {
    const glm::uvec2 bits((texel.x >> 20U) & 0x3FFU, (texel.x >> 30U) | ((texel.y >> 24U) << 2U));
    const glm::vec2 point = glm::vec2(bits) - 512.0F;
    glm::vec3 normal(point, 511.0F - std::abs(point.x) - std::abs(point.y));
    const float fold = std::max(-normal.z, 0.0F);
    normal.x -= std::copysign(fold, normal.x);
    normal.y -= std::copysign(fold, normal.y);
    return glm::normalize(normal);
}

} // namespace

Studio::Studio(std::unique_ptr<gpu::Context> context)
    : context_(std::move(context)),
      renderer_(shadows::shader_folders()),
      own_shadows_(std::make_unique<shadows::ShadowSystem>()),
      shadows_(own_shadows_.get()) {
    own_shadows_->wraps_stencil = gpu::probe_driver().wraps_stencil;
}

std::unique_ptr<shadows::ShadowSystem> Studio::new_shadows() const {
    auto shadows = std::make_unique<shadows::ShadowSystem>();
    // Not probed again: that would leave state behind that frames do not expect.
    shadows->wraps_stencil = own_shadows_->wraps_stencil;
    shadows->remedies = own_shadows_->remedies;
    return shadows;
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
    shadows_->settings = level.shadows;
    const auto drawn = renderer_.draw(
        level.world,
        camera,
        lights_,
        with_shadows ? shadows_ : nullptr,
        target_,
        {.exposure = level.exposure});
    context_->finish();
    return drawn;
}

engine::Image Studio::color() const {
    return gpu::read_image(color_);
}

Studio::Surfaces Studio::surfaces() const {
    const auto packed = gpu::read_uint_pairs(renderer_.gbuffer().surface());
    Surfaces surfaces;
    surfaces.receiver.reserve(packed.values.size());
    surfaces.normal.reserve(packed.values.size());
    for (const glm::uvec2& texel : packed.values) {
        surfaces.receiver.push_back(texel.x & kReceiverMask);
        surfaces.normal.push_back(normal_of(texel));
    }
    return surfaces;
}

std::vector<float> Studio::view_depth(const scene::CameraView& camera) const {
    std::vector<float> depth = gpu::read_depth(renderer_.gbuffer().depth()).values;
    for (float& value : depth)
        value = value > 0.0F ? camera.near / value : std::numeric_limits<float>::infinity();
    return depth;
}

} // namespace gnomon
