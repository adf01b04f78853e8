// Connected regions of a picture.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace measure {

struct Blobs {
    std::size_t count = 0;
    std::size_t largest_px = 0;
};

/// Regions of nonzero pixels, joined over sides and corners.
/// @param marked width x height, top row first; consumed
/// Cost: linear in pixels.
Blobs find_blobs(int width, int height, std::vector<std::uint8_t> marked);

} // namespace measure
