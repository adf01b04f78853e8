#include "tools/measure/filter.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cstddef>

namespace measure {

namespace {

/// Filters one line of `count` values that lie `stride` apart.
void filter_line(
    const float* from,
    std::size_t stride,
    int count,
    const Kernel& kernel,
    std::vector<float>& line,
    float* to) {
    const int radius = static_cast<int>(kernel.size() / 2);
    line.resize(static_cast<std::size_t>(count + 2 * radius));
    for (int i = 0; i < count + 2 * radius; ++i) {
        const int inside = std::clamp(i - radius, 0, count - 1);
        line[static_cast<std::size_t>(i)] = from[static_cast<std::size_t>(inside) * stride];
    }
    for (int i = 0; i < count; ++i) {
        float sum = 0.0F;
        for (std::size_t tap = 0; tap < kernel.size(); ++tap)
            sum += kernel[tap] * line[static_cast<std::size_t>(i) + tap];
        to[static_cast<std::size_t>(i) * stride] = sum;
    }
}

} // namespace

Kernel kernel(int radius, const std::function<double(double)>& weight) {
    Kernel result;
    for (int i = -radius; i <= radius; ++i)
        result.push_back(static_cast<float>(weight(i)));
    return result;
}

Kernel normalised(Kernel kernel) {
    float positive = 0.0F;
    float negative = 0.0F;
    for (const float weight : kernel)
        (weight > 0.0F ? positive : negative) += weight;
    for (float& weight : kernel)
        if (weight != 0.0F) weight /= weight > 0.0F ? positive : -negative;
    return kernel;
}

Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
    const auto width = static_cast<std::size_t>(plane.width);
    CHECK_EQ(plane.values.size(), width * static_cast<std::size_t>(plane.height));
    Plane result = plane;
    std::vector<float> line;
    for (std::size_t y = 0; y < static_cast<std::size_t>(plane.height); ++y) {
        float* row = result.values.data() + y * width;
        filter_line(row, 1, plane.width, along_x, line, row);
    }
    for (std::size_t x = 0; x < width; ++x) {
        float* column = result.values.data() + x;
        filter_line(column, width, plane.height, along_y, line, column);
    }
    return result;
}

} // namespace measure
