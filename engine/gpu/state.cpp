#include "engine/gpu/state.hpp"

#include "engine/core/check.hpp"

namespace gpu {

namespace {

void enable(GLenum capability, bool on) {
    if (on) {
        glEnable(capability);
    } else {
        glDisable(capability);
    }
}

void apply_depth_test(const RenderState& state) {
    enable(GL_DEPTH_TEST, state.depth_test != Compare::always || state.depth_write);
    glDepthFunc(static_cast<GLenum>(state.depth_test));
    glDepthMask(state.depth_write ? GL_TRUE : GL_FALSE);
}

void apply_stencil_face(GLenum face, const StencilFace& stencil) {
    glStencilFuncSeparate(
        face, static_cast<GLenum>(stencil.test), stencil.reference, stencil.read_mask);
    glStencilOpSeparate(
        face,
        static_cast<GLenum>(stencil.on_stencil_fail),
        static_cast<GLenum>(stencil.on_depth_fail),
        static_cast<GLenum>(stencil.on_pass));
    glStencilMaskSeparate(face, stencil.write_mask);
}

void apply_stencil(const std::optional<Stencil>& stencil) {
    enable(GL_STENCIL_TEST, stencil.has_value());
    if (!stencil) return;
    apply_stencil_face(GL_FRONT, stencil->front);
    apply_stencil_face(GL_BACK, stencil->back);
}

struct BlendFunction {
    GLenum equation;
    GLenum source;
    GLenum target;
};

BlendFunction blend_function(Blend blend) {
    switch (blend) {
    case Blend::off:
    case Blend::add:
        return {GL_FUNC_ADD, GL_ONE, GL_ONE};
    case Blend::subtract:
        return {GL_FUNC_REVERSE_SUBTRACT, GL_ONE, GL_ONE};
    case Blend::min:
        return {GL_MIN, GL_ONE, GL_ONE};
    case Blend::max:
        return {GL_MAX, GL_ONE, GL_ONE};
    case Blend::multiply:
        return {GL_FUNC_ADD, GL_DST_COLOR, GL_ZERO};
    case Blend::alpha:
        return {GL_FUNC_ADD, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
    }
    return {GL_FUNC_ADD, GL_ONE, GL_ZERO};
}

void apply_blend(Blend blend) {
    enable(GL_BLEND, blend != Blend::off);
    if (blend == Blend::off) return;
    const BlendFunction function = blend_function(blend);
    glBlendEquation(function.equation);
    glBlendFunc(function.source, function.target);
}

void apply_color_write(std::uint8_t bits) {
    const auto allowed = [bits](unsigned bit) -> GLboolean {
        return (bits & bit) != 0 ? GL_TRUE : GL_FALSE;
    };
    glColorMask(
        allowed(kWriteRed), allowed(kWriteGreen), allowed(kWriteBlue), allowed(kWriteAlpha));
}

void apply_cull(Cull cull) {
    enable(GL_CULL_FACE, cull != Cull::none);
    if (cull != Cull::none) glCullFace(cull == Cull::back ? GL_BACK : GL_FRONT);
}

void apply_scissor(const std::optional<Rect>& scissor) {
    enable(GL_SCISSOR_TEST, scissor.has_value());
    if (scissor) glScissor(scissor->x, scissor->y, scissor->width, scissor->height);
}

void apply_clip_distances(unsigned count) {
    constexpr unsigned kLeastOffered = 8; // OpenGL 4.5, table 23.54: MAX_CLIP_DISTANCES
    CHECK_LE(count, kLeastOffered);
    for (unsigned i = 0; i < kLeastOffered; ++i)
        enable(GL_CLIP_DISTANCE0 + i, i < count);
}

} // namespace

StateGroups difference(const RenderState& from, const RenderState& to) {
    StateGroups groups;
    const auto mark = [&groups](StateGroup group, bool differs) {
        groups[static_cast<std::size_t>(group)] = differs;
    };
    mark(
        StateGroup::depth_test,
        from.depth_test != to.depth_test || from.depth_write != to.depth_write);
    mark(StateGroup::depth_clamp, from.depth_clamp != to.depth_clamp);
    mark(StateGroup::cull, from.cull != to.cull);
    mark(StateGroup::front_face, from.front_face != to.front_face);
    mark(StateGroup::color_write, from.color_write != to.color_write);
    mark(StateGroup::stencil, from.stencil != to.stencil);
    mark(StateGroup::blend, from.blend != to.blend);
    mark(StateGroup::scissor, from.scissor != to.scissor);
    mark(StateGroup::viewport, from.viewport != to.viewport);
    mark(StateGroup::clip_distances, from.clip_distances != to.clip_distances);
    mark(StateGroup::wireframe, from.wireframe != to.wireframe);
    return groups;
}

void StateCache::set_target(const Framebuffer& target) {
    target_rect_ = target.whole();
    // Only the draw binding: reads and blits name their framebuffers.
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
    ++change_count_;
    forget_bindings();
}

void StateCache::set(const RenderState& state) {
    RenderState wanted = state;
    if (!wanted.viewport) wanted.viewport = target_rect_;
    const StateGroups groups = known_ ? difference(state_, wanted) : StateGroups().set();
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i]) apply(static_cast<StateGroup>(i), wanted);
    }
    change_count_ += groups.count();
    state_ = wanted;
    known_ = true;
}

void StateCache::apply(StateGroup group, const RenderState& state) {
    switch (group) {
    case StateGroup::depth_test:
        apply_depth_test(state);
        break;
    case StateGroup::depth_clamp:
        enable(GL_DEPTH_CLAMP, state.depth_clamp);
        break;
    case StateGroup::cull:
        apply_cull(state.cull);
        break;
    case StateGroup::front_face:
        glFrontFace(state.front_face == FrontFace::counter_clockwise ? GL_CCW : GL_CW);
        break;
    case StateGroup::color_write:
        apply_color_write(state.color_write);
        break;
    case StateGroup::stencil:
        apply_stencil(state.stencil);
        break;
    case StateGroup::blend:
        apply_blend(state.blend);
        break;
    case StateGroup::scissor:
        apply_scissor(state.scissor);
        break;
    case StateGroup::viewport:
        glViewport(
            state.viewport->x, state.viewport->y, state.viewport->width, state.viewport->height);
        break;
    case StateGroup::clip_distances:
        apply_clip_distances(state.clip_distances);
        break;
    case StateGroup::wireframe:
        glPolygonMode(GL_FRONT_AND_BACK, state.wireframe ? GL_LINE : GL_FILL);
        break;
    case StateGroup::count:
        break;
    }
}

void StateCache::set_program(GLuint name) {
    if (program_ == name) return;
    program_ = name;
    glUseProgram(name);
    ++change_count_;
}

void StateCache::set_vertex_array(GLuint name) {
    if (vertex_array_ == name) return;
    vertex_array_ = name;
    glBindVertexArray(name);
    ++change_count_;
}

void StateCache::forget_bindings() {
    program_.reset();
    vertex_array_.reset();
}

void StateCache::forget() {
    known_ = false;
    forget_bindings();
}

} // namespace gpu
