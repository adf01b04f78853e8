#include "tools/measure/blobs.hpp"

#include "engine/core/check.hpp"

#include <algorithm>

namespace measure {

namespace {

/// Clears the region round `seed` and returns its size.
std::size_t
erase_region(int width, int height, std::size_t seed, std::vector<std::uint8_t>& marked) {
    std::vector<std::size_t> pending = {seed};
    marked[seed] = 0;
    std::size_t size = 0;
    while (!pending.empty()) {
        const auto at = static_cast<int>(pending.back());
        pending.pop_back();
        ++size;
        const int x = at % width;
        const int y = at / width;
        for (int ny = std::max(0, y - 1); ny <= std::min(height - 1, y + 1); ++ny)
            for (int nx = std::max(0, x - 1); nx <= std::min(width - 1, x + 1); ++nx) {
                const auto neighbour = static_cast<std::size_t>(ny * width + nx);
                if (marked[neighbour] == 0) continue;
                marked[neighbour] = 0;
                pending.push_back(neighbour);
            }
    }
    return size;
}

} // namespace

Blobs find_blobs(int width, int height, std::vector<std::uint8_t> marked) {
    CHECK_EQ(marked.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    Blobs blobs;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked[i] == 0) continue;
        ++blobs.count;
        blobs.largest_px = std::max(blobs.largest_px, erase_region(width, height, i, marked));
    }
    return blobs;
}

} // namespace measure
