// Shadow edges in pictures: cracks between pixels, their length, and the distance to the nearest
// one.
//
// Places are counted in half pixels, so that pixel centres and crack midpoints share one grid of
// (2 width + 1) x (2 height + 1) points: the centre of pixel (x, y) is (2x + 1, 2y + 1).

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/measure/mask.hpp"

namespace measure {

/// The midpoint of the side that a lit and a dark pixel share, in half pixels.
struct Crack {
    int x = 0;
    int y = 0;
};

/// All cracks between valid 4-neighbours, row by row. An undecided pixel does not interrupt an
/// edge: where the valid pixels on its two sides differ, the crack is drawn on the side where it
/// differs itself. Without that, one true edge pixel in ten would be lost, since truth is undecided
/// where an edge runs close to a pixel's centre.
std::vector<Crack> cracks(const Mask& mask, std::span<const PixelKind> kind);

/// Length in px of an edge without a preferred direction.
/// Source: Crofton's formula for the square grid: length = pi / 4 x number of grid lines crossed.
double crofton_length(std::size_t crack_count);

/// Exact Euclidean distance from every point of the half-pixel grid to the nearest crack.
/// Source: Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions", 2012.
/// Cost: linear in pixels; 4 floats a pixel.
class DistanceField {
public:
    DistanceField(int width, int height, std::span<const Crack> cracks);

    /// In px; infinite when there is no crack.
    [[nodiscard]] float to(const Crack& crack) const { return at(crack.x, crack.y); }
    [[nodiscard]] float to_pixel(int x, int y) const { return at(2 * x + 1, 2 * y + 1); }

private:
    [[nodiscard]] float at(int x, int y) const {
        return distance_px_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
    }

    std::size_t columns_;
    std::vector<float> distance_px_;
};

} // namespace measure
