// Rectangles of the screen, as passes are scissored to them.

#pragma once

#include "engine/gpu/texture.hpp"
#include "systems/shadows/screen_bounds.hpp"

#include <algorithm>

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

} // namespace shadows
