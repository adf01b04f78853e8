// A pass is a scope: a target, what to clear, a debug group, a timer, and an end that cannot be
// forgotten.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/gpu/framebuffer.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <string_view>

namespace gpu {

/// What a pass starts from; what is not named keeps its contents.
struct Clear {
    std::optional<glm::vec4> color =
        {};                          ///< of every colour attachment; integer formats get it rounded
    std::optional<float> depth = {}; ///< 0 is infinitely far
    std::optional<int> stencil = {};
    std::optional<Rect> area = {}; ///< none: the whole target
};

class ScopedPass {
public:
    /// Passes do not nest.
    /// @param name   "technique/light", as people read it in a frame debugger, in stats.json and in
    /// the overlay
    /// @param target must outlive the pass
    ScopedPass(
        Frame& frame, std::string_view name, const Framebuffer& target, const Clear& clear = {});

    /// A pass of dispatches, without a target.
    ScopedPass(Frame& frame, std::string_view name);

    ~ScopedPass();
    ScopedPass(const ScopedPass&) = delete;
    ScopedPass& operator=(const ScopedPass&) = delete;
    ScopedPass(ScopedPass&&) = delete;
    ScopedPass& operator=(ScopedPass&&) = delete;

private:
    Frame& frame_;
};

/// Clears outside of a pass's beginning; leaves RenderState{} with `clear.area` as its scissor.
void clear_target(Frame& frame, const Framebuffer& target, const Clear& clear);

} // namespace gpu
