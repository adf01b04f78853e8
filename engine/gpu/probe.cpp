// The probes draw what drivers have got wrong, and look at the result.

#include "engine/gpu/probe.hpp"

#include "engine/core/check.hpp"
#include "engine/gpu/pass.hpp"
#include "engine/gpu/pass_timer.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/shader_library.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace gpu {

namespace {

/// A program whose shaders come with this module, so that only a broken driver can refuse it; null
/// then.
const Program*
own_program(ShaderLibrary& library, const std::string& vertex, const std::string& fragment) {
    const engine::Result<const Program*> program = library.graphics(vertex, fragment);
    return program ? *program : nullptr;
}

/// Depth and stencil of a few pixels.
class DepthStencilProbe {
public:
    DepthStencilProbe()
        : texture_("probe depth", {.format = Format::depth32f_stencil8, .width = 4, .height = 4}),
          target_(Framebuffer::make("probe", {.depth = Attachment{.texture = &texture_}})),
          program_(own_program(library_, "gpu/probe.vert", "gpu/probe.frag")) {}

    [[nodiscard]] bool usable() const { return target_ && program_ != nullptr; }

    /// Draws two triangles that cover the target at depth z, the first facing away, over depth 0.5
    /// and stencil 0.
    void draw(const RenderState& state, float z) {
        frame_.begin();
        {
            const ScopedPass pass(frame_, "probe", *target_, {.depth = 0.5F, .stencil = 0});
            frame_.state(state);
            program_->set("depth", z);
            frame_.draw(*program_, no_vertices_, {.count = 6});
        }
        frame_.end();
    }

    [[nodiscard]] float depth() const { return read_depth(texture_).at(1, 1); }
    [[nodiscard]] int stencil() const { return read_stencil(texture_).at(1, 1); }

private:
    ShaderLibrary library_{{}};
    Texture texture_;
    engine::Result<Framebuffer> target_;
    const Program* program_;
    Frame frame_{TimerBackend::finish};
    VertexArray no_vertices_ = VertexArray::none();
};

bool clamps_depth(DepthStencilProbe& probe) {
    const RenderState state = {
        .depth_test = Compare::always, .depth_clamp = true, .cull = Cull::none};
    probe.draw(state, 2.0F);
    const bool near_side = probe.depth() == 1.0F;
    probe.draw(state, -1.0F);
    return near_side && probe.depth() == 0.0F;
}

bool wraps_stencil(DepthStencilProbe& probe) {
    probe.draw(
        {.depth_test = Compare::always,
         .depth_write = false,
         .cull = Cull::none,
         .stencil =
             Stencil{
                 .front = {.on_pass = StencilOp::increment_wrap},
                 .back = {.on_pass = StencilOp::decrement_wrap}}},
        0.5F);
    return probe.stencil() == 0;
}

} // namespace

DriverProbe probe_driver() {
    DepthStencilProbe probe;
    if (!probe.usable()) return {};
    return {.clamps_depth = clamps_depth(probe), .wraps_stencil = wraps_stencil(probe)};
}

} // namespace gpu
