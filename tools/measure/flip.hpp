// How different two pictures look to someone who flips between them.
//
// Both pictures are filtered as the eye filters them at a viewing distance, compared by colour, and
// the difference is raised where edges or points came or went. 0: no difference; 1: the largest
// there is.

#pragma once

#include "engine/core/image.hpp"

#include <vector>

namespace measure {

/// A picture of 3840 px, 0.7 m wide, seen from 0.7 m.
inline constexpr double kPixelsPerDegree = 67.0;

/// The difference at every pixel, 0 to 1, top row first.
/// @param picture_a, picture_b 8-bit sRGB with 3 or 4 channels (the fourth is not looked at); the
/// order does not matter
/// @param pixels_per_degree of the viewer's sight
/// @pre both have the same size, and a pixel
/// Cost: about 200 multiplications a pixel and picture.
/// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", 2020 (low dynamic range).
std::vector<float> flip(
    const engine::Image& picture_a,
    const engine::Image& picture_b,
    double pixels_per_degree = kPixelsPerDegree);

} // namespace measure
