// Rectangles of the screen, as passes are scissored to them.

#pragma once

#include "engine/gpu/texture.hpp"
#include "systems/shadows/screen_bounds.hpp"

#include <algorithm>
#include <cstdint>

namespace shadows {

inline gpu::Rect to_rect(const PixelBox& box) {
    return {box.left, box.bottom, box.right - box.left, box.top - box.bottom};
}

/// What two rectangles share; may be empty().
inline gpu::Rect intersection(const gpu::Rect& a, const gpu::Rect& b) {
    const int left = std::max(a.x, b.x);
    const int bottom = std::max(a.y, b.y);
    return {
        left,
        bottom,
        std::min(a.x + a.width, b.x + b.width) - left,
        std::min(a.y + a.height, b.y + b.height) - bottom};
}

/// The smallest rectangle round two; `a` may be empty.
inline gpu::Rect hull(const gpu::Rect& a, const gpu::Rect& b) {
    if (a.empty()) return b;
    const int left = std::min(a.x, b.x);
    const int bottom = std::min(a.y, b.y);
    return {
        left,
        bottom,
        std::max(a.x + a.width, b.x + b.width) - left,
        std::max(a.y + a.height, b.y + b.height) - bottom};
}

inline std::uint64_t pixels(const gpu::Rect& rect) {
    return static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
}

} // namespace shadows
