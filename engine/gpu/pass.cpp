#include "engine/gpu/pass.hpp"

#include "engine/core/check.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace gpu {

namespace {

void clear_color(const Framebuffer& target, int index, Format format, const glm::vec4& color) {
    if (traits(format).integer) {
        const glm::uvec4 whole(glm::max(glm::round(color), 0.0F));
        glClearNamedFramebufferuiv(target.name(), GL_COLOR, index, glm::value_ptr(whole));
    } else {
        glClearNamedFramebufferfv(target.name(), GL_COLOR, index, glm::value_ptr(color));
    }
}

} // namespace

void clear_target(Frame& frame, const Framebuffer& target, const Clear& clear) {
    if (!clear.color && !clear.depth && !clear.stencil) return;
    // Clears obey the write masks and the scissor; a stencil without tests opens its mask.
    frame.state({.stencil = Stencil{}, .scissor = clear.area});
    if (clear.color) {
        int index = 0;
        for (const Format format : target.color_formats()) {
            clear_color(target, index, format, *clear.color);
            ++index;
        }
    }
    if (clear.depth && clear.stencil) {
        glClearNamedFramebufferfi(target.name(), GL_DEPTH_STENCIL, 0, *clear.depth, *clear.stencil);
    } else if (clear.depth) {
        glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &*clear.depth);
    } else if (clear.stencil) {
        glClearNamedFramebufferiv(target.name(), GL_STENCIL, 0, &*clear.stencil);
    }
}

ScopedPass::ScopedPass(
    Frame& frame, std::string_view name, const Framebuffer& target, const Clear& clear)
    : ScopedPass(frame, name) {
    frame.state_.set_target(target);
    clear_target(frame, target, clear);
    frame.state({});
}

ScopedPass::ScopedPass(Frame& frame, std::string_view name) : frame_(frame) {
    CHECK(frame.open_);
    CHECK(!frame.in_pass_);
    frame.in_pass_ = true;
    glPushDebugGroup(
        GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
    frame.timers_.begin_pass(name);
    frame.state_.forget_bindings();
}

ScopedPass::~ScopedPass() {
    frame_.timers_.end_pass();
    glPopDebugGroup();
    frame_.in_pass_ = false;
}

} // namespace gpu
