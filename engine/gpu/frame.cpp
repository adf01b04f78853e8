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

/// Element `index` of the bound buffer, as OpenGL's draws take it: an offset in the guise of a
/// pointer.
const void* place_in_buffer(std::uint32_t index, std::size_t element_bytes) {
    const std::uintptr_t offset_bytes = index * element_bytes;
    // NOLINTNEXTLINE(performance-no-int-to-ptr,cppcoreguidelines-pro-type-reinterpret-cast)
    return reinterpret_cast<const void*>(offset_bytes);
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
        glDrawElementsInstancedBaseVertexBaseInstance(
            mode,
            count,
            GL_UNSIGNED_INT,
            place_in_buffer(range.first, sizeof(std::uint32_t)),
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
    glMultiDrawElementsIndirect(
        static_cast<GLenum>(range.primitive),
        GL_UNSIGNED_INT,
        place_in_buffer(range.first, kCommandBytes),
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
