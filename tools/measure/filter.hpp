// Filtering a picture of numbers by kernels that are products of a row and a column.

#pragma once

#include <functional>
#include <vector>

namespace measure {

/// One number per pixel, top row first.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// Weights at the places -radius .. radius.
using Kernel = std::vector<float>;

/// @param weight at a distance in px from the middle
Kernel kernel(int radius, const std::function<double(double)>& weight);
/// Positive weights add up to 1, negative ones to -1, each if there are any.
Kernel normalised(Kernel kernel);

/// Beyond its border the picture goes on as it ends.
Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y);

} // namespace measure
