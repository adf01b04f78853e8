// Pixels from the device to memory, top row first. Each call waits for the device: for captures and
// tests.

#pragma once

#include "engine/core/image.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/texture.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpu {

/// Pixels of one layer, row by row from the top.
template <class T>
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<T> values;

    /// y down from the top.
    [[nodiscard]] const T& at(int x, int y) const {
        return values
            [static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
             + static_cast<std::size_t>(x)];
    }
};

/// @pre the texture is r8, rg8 (as three channels, blue 0), rgba8 or srgb8_alpha8
/// @return 1, 3 or 4 channels, as stored
engine::Image read_image(const Texture& texture, int level = 0, int layer = 0);

/// One 32-bit unsigned integer a pixel. @pre an integer format with one channel
Pixels<std::uint32_t> read_uints(const Texture& texture, int level = 0, int layer = 0);

/// @pre rg32ui
Pixels<glm::uvec2> read_uint_pairs(const Texture& texture, int level = 0, int layer = 0);

/// The first channel of a float or normalised format. @pre not an integer format, not depth
Pixels<float> read_floats(const Texture& texture, int level = 0, int layer = 0);

/// All four channels; absent ones read 0, 0, 1. @pre not an integer format, not depth
Pixels<glm::vec4> read_vectors(const Texture& texture, int level = 0, int layer = 0);

/// 1 at the near plane, 0 at infinity. @pre a depth format
Pixels<float> read_depth(const Texture& texture, int level = 0, int layer = 0);

/// @pre depth32f_stencil8
Pixels<std::uint8_t> read_stencil(const Texture& texture, int level = 0, int layer = 0);

/// What the window shows, before it is swapped: three channels.
engine::Image read_window(const Framebuffer& window);

} // namespace gpu
