#include "engine/gpu/frame.hpp"

#include "engine/core/check.hpp"

namespace gpu {

namespace {

std::uint64_t triangle_count(const DrawRange& range) {
    std::uint64_t per_instance = 0;
    if (range.primitive == Primitive::triangles) per_instance = range.count / 3;
    if (range.primitive == Primitive::triangle_strip && range.count > 2) {
        per_instance = range.count - 2;
    }
    return per_instance * range.instances;
}

} // namespace

Frame::Frame(TimerBackend timer) : timers_(timer), no_vertices_(VertexArray::none()) {}

void Frame::begin() {
    CHECK(!open_);
    open_ = true;
    ++number_;
    counters_ = {};
    changes_before_ = state_.change_count();
    timers_.begin_frame();
}

void Frame::end() {
    CHECK(open_);
    CHECK(!in_pass_);
    open_ = false;
    timers_.end_frame();
    counters_.state_changes = state_.change_count() - changes_before_;
}

void Frame::draw(const Program& program, const VertexArray& vertices, const DrawRange& range) {
    CHECK(in_pass_);
    if (range.count == 0 || range.instances == 0) return;
    state_.set_program(program.name());
    state_.set_vertex_array(vertices.name());
    const auto mode = static_cast<GLenum>(range.primitive);
    const auto count = static_cast<GLsizei>(range.count);
    const auto instances = static_cast<GLsizei>(range.instances);
    if (vertices.indexed()) {
        // The last argument of the call is an offset in bytes in the guise of a pointer.
        const auto offset_bytes = static_cast<std::uintptr_t>(range.first) * sizeof(std::uint32_t);
        glDrawElementsInstancedBaseVertexBaseInstance(
            mode,
            count,
            GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(
                offset_bytes), // NOLINT(performance-no-int-to-ptr,cppcoreguidelines-pro-type-reinterpret-cast):
                               // OpenGL's own convention
            instances,
            range.base_vertex,
            range.base_instance);
    } else {
        glDrawArraysInstancedBaseInstance(
            mode, static_cast<GLint>(range.first), count, instances, range.base_instance);
    }
    ++counters_.draws;
    counters_.triangles += triangle_count(range);
}

void Frame::draw_indirect(
    const Program& program, const VertexArray& vertices, const IndirectRange& range) {
    CHECK(in_pass_);
    CHECK(vertices.indexed());
    if (range.count == 0) return;
    constexpr std::size_t kCommandBytes = 5 * sizeof(std::uint32_t);
    state_.set_program(program.name());
    state_.set_vertex_array(vertices.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, range.commands->name());
    const auto offset_bytes = static_cast<std::uintptr_t>(range.first) * kCommandBytes;
    glMultiDrawElementsIndirect(
        static_cast<GLenum>(range.primitive),
        GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(
            offset_bytes), // NOLINT(performance-no-int-to-ptr,cppcoreguidelines-pro-type-reinterpret-cast):
                           // OpenGL's own convention
        static_cast<GLsizei>(range.count),
        0);
    ++counters_.draws;
    counters_.triangles += range.triangles;
}

void Frame::draw_fullscreen(const Program& program) {
    draw(program, no_vertices_, {.count = 3});
}

void Frame::dispatch(
    const Program& program, unsigned groups_x, unsigned groups_y, unsigned groups_z) {
    CHECK(in_pass_);
    CHECK(groups_x > 0 && groups_y > 0 && groups_z > 0);
    state_.set_program(program.name());
    glDispatchCompute(groups_x, groups_y, groups_z);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace gpu
