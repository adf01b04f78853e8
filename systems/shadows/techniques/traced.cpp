// Visibility traced per pixel and uploaded: exact, and far too slow to play with. Right for
// comparing: what a picture would look like if its shadows were perfect. Its artefacts are those of
// one sample per pixel: hard edges are aliased.

#include "engine/gpu/pass.hpp"
#include "engine/render/light_visibility.hpp"
#include "engine/trace/visibility.hpp"
#include "systems/shadows/error_model.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/receiver_bits.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

#include <cmath>
#include <optional>

namespace shadows {

namespace {

constexpr int kDefaultSamples = 64;

int sample_count(const scene::Light& light, const scene::ShadowWish& wish) {
    const bool hard = light.radius == 0.0F && light.angular_radius == 0.0F;
    return hard ? 1 : wish.samples.value_or(kDefaultSamples);
}

bool same_view(const scene::CameraView& a, const scene::CameraView& b) {
    return a.position == b.position && a.world_from_view == b.world_from_view && a.fov_y == b.fov_y
           && a.near == b.near && a.width == b.width && a.height == b.height;
}

class TracedJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_ = request.scene.lights[request.light];
        truth_ = &request.truth();
        samples_ = sample_count(light_.light, request.wish);
        receivers_.assign(request.plans, request.receiver_end);
        traced_view_.reset();
        return {};
    }

    engine::Result<void> render(
        gpu::Frame& /*frame*/,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& /*geometry*/) override {
        const auto program = shaders.graphics("gpu/fullscreen.vert", "shadows/traced.frag");
        if (!program) return program.error();
        program_ = *program;
        return {};
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        if (!traced_view_ || !same_view(*traced_view_, camera)) trace(camera);
        const gpu::ScopedPass pass(frame, fmt::format("traced/{}", light_.name), target.mask);
        gpu::RenderState state = gpu::kScreenState;
        state.blend = gpu::Blend::min;
        state.scissor = target.area;
        frame.state(state);
        receivers_.bind();
        target.gbuffer.bind(UNIT_GBUFFER);
        visibility_.bind(UNIT_VISIBILITY);
        frame.draw_fullscreen(*program_);
        const auto pixels = static_cast<std::uint64_t>(target.area.width)
                            * static_cast<std::uint64_t>(target.area.height);
        frame.counters().mask_fragments += pixels;
        frame.counters().taps += pixels;
    }

private:
    void trace(const scene::CameraView& camera) {
        trace::VisibilityOptions options;
        options.samples = samples_;
        const trace::VisibilityImage image =
            trace::trace_visibility(*truth_, camera, light_, options);
        std::vector<std::uint8_t> bytes(image.visibility.size());
        const auto width = static_cast<std::size_t>(camera.width);
        for (std::size_t row = 0; row < static_cast<std::size_t>(camera.height); ++row) {
            const std::size_t from = (static_cast<std::size_t>(camera.height) - 1 - row) * width;
            for (std::size_t column = 0; column < width; ++column)
                bytes[row * width + column] = static_cast<std::uint8_t>(
                    std::lround(image.visibility[from + column] * 255.0F));
        }
        if (visibility_.width() != camera.width || visibility_.height() != camera.height
            || !visibility_)
            visibility_ = gpu::Texture(
                "traced/" + light_.name,
                {.format = gpu::Format::r8, .width = camera.width, .height = camera.height});
        visibility_.upload(gpu::bytes_of(bytes));
        traced_view_ = camera;
    }

    LightView light_;
    const trace::TraceScene* truth_ = nullptr;
    int samples_ = 1;
    ReceiverBits receivers_;
    const gpu::Program* program_ = nullptr;
    gpu::Texture visibility_;
    std::optional<scene::CameraView> traced_view_; ///< what visibility_ shows; none after an update
};

class Traced final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "traced", "visibility from the truth tracer; for comparison only", false};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& /*casters*/) const override {
        Prediction prediction;
        // A primary and a shadow ray for each pixel; of area lights many more, which nobody plans
        // with.
        prediction.cost.rays = 2.0 * screen_area_px(pair.scene.camera, pair.receiver.bounds);
        prediction.cost.taps = prediction.cost.rays * 0.5;
        return prediction;
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<TracedJob>();
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_traced() {
    return std::make_unique<Traced>();
}

} // namespace shadows
