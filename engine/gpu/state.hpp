// Render state as a value. A pass says what it wants in full; the cache applies what differs from
// what is set, and nobody restores anything.

#pragma once

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/texture.hpp"

#include <epoxy/gl.h>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace gpu {

/// Depth is reversed: 1 at the near plane, 0 at infinity; nearer is greater.
enum class Compare : GLenum {
    never = GL_NEVER,
    less = GL_LESS,
    equal = GL_EQUAL,
    less_equal = GL_LEQUAL,
    greater = GL_GREATER,
    not_equal = GL_NOTEQUAL,
    greater_equal = GL_GEQUAL,
    always = GL_ALWAYS,
};

enum class StencilOp : GLenum {
    keep = GL_KEEP,
    zero = GL_ZERO,
    replace = GL_REPLACE,
    increment_clamp = GL_INCR,
    decrement_clamp = GL_DECR,
    increment_wrap = GL_INCR_WRAP,
    decrement_wrap = GL_DECR_WRAP,
    invert = GL_INVERT,
};

enum class Cull : std::uint8_t { none, back, front };

/// The winding of a front face on screen; mirrored meshes turn it round.
enum class FrontFace : std::uint8_t { counter_clockwise, clockwise };

/// How a fragment meets what the target holds. Applies to every colour attachment.
enum class Blend : std::uint8_t {
    off,
    add,      ///< target + fragment
    subtract, ///< target - fragment
    min,
    max,
    multiply, ///< target * fragment
    alpha,    ///< fragment over target by the fragment's alpha, not premultiplied
};

struct StencilFace {
    Compare test = Compare::always; ///< (reference & read_mask) against (stored & read_mask)
    StencilOp on_stencil_fail = StencilOp::keep;
    StencilOp on_depth_fail = StencilOp::keep;
    StencilOp on_pass = StencilOp::keep;
    std::uint8_t reference = 0;
    std::uint8_t read_mask = 0xFF;
    std::uint8_t write_mask = 0xFF;

    bool operator==(const StencilFace&) const = default;
};

struct Stencil {
    StencilFace front = {};
    StencilFace back = {};

    bool operator==(const Stencil&) const = default;
    static Stencil both(const StencilFace& face) { return {face, face}; }
};

/// Bits of RenderState::color_write.
inline constexpr std::uint8_t kWriteRed = 1;
inline constexpr std::uint8_t kWriteGreen = 2;
inline constexpr std::uint8_t kWriteBlue = 4;
inline constexpr std::uint8_t kWriteAlpha = 8;
inline constexpr std::uint8_t kWriteColor = 15;
inline constexpr std::uint8_t kWriteNoColor = 0;

/// Everything that a draw takes from the fixed functions. The default draws opaque geometry.
struct RenderState {
    Compare depth_test = Compare::greater; ///< `always` with depth_write off means no depth test
    bool depth_write = true;
    bool depth_clamp = true; ///< keeps what is nearer than the near plane, at depth 1
    Cull cull = Cull::back;
    FrontFace front_face = FrontFace::counter_clockwise;
    std::uint8_t color_write = kWriteColor;
    std::optional<Stencil> stencil = {}; ///< none: no test, no writes
    Blend blend = Blend::off;
    std::optional<Rect> scissor = {};  ///< none: no scissor
    std::optional<Rect> viewport = {}; ///< none: the whole target
    std::uint8_t clip_distances = 0;   ///< gl_ClipDistance[0 .. n-1] are in use; at most 8
    bool wireframe = false;

    bool operator==(const RenderState&) const = default;
};

/// State for a pass over the screen: no depth, no culling; add what the pass needs.
inline constexpr RenderState kScreenState = {
    .depth_test = Compare::always, .depth_write = false, .depth_clamp = false, .cull = Cull::none};

/// The parts in which state is applied.
enum class StateGroup : std::uint8_t {
    depth_test, ///< with depth_write: OpenGL writes depth only where it tests
    depth_clamp,
    cull,
    front_face,
    color_write,
    stencil,
    blend,
    scissor,
    viewport,
    clip_distances,
    wireframe,
    count,
};

using StateGroups = std::bitset<static_cast<std::size_t>(StateGroup::count)>;

/// The groups in which two states differ.
StateGroups difference(const RenderState& from, const RenderState& to);

/// Knows what is set in the current context and sets the rest. Programs, vertex arrays and targets
/// pass through here too, so that none is bound twice.
class StateCache {
public:
    /// Draws go to `target` from now on; its size is the default viewport.
    void set_target(const Framebuffer& target);
    void set(const RenderState& state);
    void set_program(GLuint name);
    void set_vertex_array(GLuint name);

    /// Called at the start of each pass: OpenGL may since have given the name of a deleted object
    /// to a new one.
    void forget_bindings();

    /// Call after foreign code (a panel's back end) has changed OpenGL's state: all is set anew.
    void forget();

    [[nodiscard]] std::uint64_t change_count() const { return change_count_; }
    [[nodiscard]] Rect target_rect() const { return target_rect_; }

private:
    static void apply(StateGroup group, const RenderState& state);

    RenderState state_;
    Rect target_rect_;
    std::optional<GLuint> program_;
    std::optional<GLuint> vertex_array_;
    bool known_ = false;
    std::uint64_t change_count_ = 0;
};

} // namespace gpu
