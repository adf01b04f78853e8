// The one way to draw: keeps state, pass timers and counters, and does every draw and dispatch so
// that none goes uncounted. One Frame per context, used again for each frame.

#pragma once

#include "engine/gpu/pass_timer.hpp"
#include "engine/gpu/program.hpp"
#include "engine/gpu/state.hpp"
#include "engine/gpu/vertex_array.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace gpu {

/// What one frame did. draws, triangles and state_changes are counted here; the rest by those who
/// know.
struct Counters {
    std::uint64_t draws = 0;
    std::uint64_t triangles = 0;
    std::uint64_t state_changes = 0;
    std::uint64_t map_texels = 0;        ///< of shadow maps and textures, redrawn
    std::uint64_t mask_fragments = 0;    ///< pixels of visibility masks, touched
    std::uint64_t stencil_fragments = 0; ///< pixels of the stencil, touched
    std::uint64_t taps = 0;              ///< reads of shadow maps and textures
};

enum class Primitive : GLenum {
    points = GL_POINTS,
    lines = GL_LINES,
    line_strip = GL_LINE_STRIP,
    triangles = GL_TRIANGLES,
    triangle_strip = GL_TRIANGLE_STRIP,
};

/// A run of indices, or of vertices where the vertex array has no indices.
struct DrawRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t instances = 1;
    std::int32_t base_vertex = 0;    ///< added to every index
    std::uint32_t base_instance = 0; ///< the first element of per-instance streams
    Primitive primitive = Primitive::triangles;
};

/// Commands in a buffer, each as glMultiDrawElementsIndirect reads them: index count, instances,
/// first index, base vertex, first instance (five 32-bit integers, packed).
struct IndirectRange {
    const Buffer* commands = nullptr;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint64_t triangles = 0; ///< of all commands together, for the counters
    Primitive primitive = Primitive::triangles;
};

class Frame {
public:
    /// Needs a current context, which must live longer.
    explicit Frame(TimerBackend timer = probe_timer_backend());

    /// Counters start from zero.
    void begin();
    /// @pre no pass is open
    void end();

    /// State for the draws that follow, until the next call or the next pass, which starts with
    /// RenderState{}.
    void state(const RenderState& state) { state_.set(state); }

    /// @pre the program is one for graphics; a pass is open
    void draw(const Program& program, const VertexArray& vertices, const DrawRange& range);

    /// Many draws in one call. @pre the vertex array has indices
    void
    draw_indirect(const Program& program, const VertexArray& vertices, const IndirectRange& range);

    /// One triangle over the viewport; the vertex shader is "gpu/fullscreen.vert".
    void draw_fullscreen(const Program& program);

    /// @param groups work groups in x, y, z; none may be 0
    /// The shader's writes are visible to everything after it.
    void dispatch(
        const Program& program, unsigned groups_x, unsigned groups_y = 1, unsigned groups_z = 1);

    [[nodiscard]] Counters& counters() { return counters_; }
    [[nodiscard]] const Counters& counters() const { return counters_; }
    [[nodiscard]] PassTimers& timers() { return timers_; }
    [[nodiscard]] const PassTimers& timers() const { return timers_; }
    [[nodiscard]] StateCache& state_cache() { return state_; }
    [[nodiscard]] std::uint64_t number() const { return number_; } ///< of begin() calls so far

private:
    friend class ScopedPass;

    StateCache state_;
    PassTimers timers_;
    Counters counters_;
    VertexArray no_vertices_;
    std::uint64_t number_ = 0;
    std::uint64_t changes_before_ = 0;
    bool open_ = false;
    bool in_pass_ = false;
};

} // namespace gpu
