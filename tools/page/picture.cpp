#include "tools/page/picture.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>

#include "tools/page/html.hpp"

namespace page {

namespace {

/// The sources that one of `to` equal parts of a row of `from` pixels covers, with their shares.
struct Part {
    int first = 0;
    std::vector<double> shares; ///< of pixels `first` and on; they add up to 1
};

std::vector<Part> parts_of(int from, int to) {
    std::vector<Part> parts(static_cast<std::size_t>(to));
    const double step = static_cast<double>(from) / to;
    for (int i = 0; i < to; ++i) {
        const double begin = i * step;
        const double end = begin + step;
        Part& part = parts[static_cast<std::size_t>(i)];
        part.first = static_cast<int>(begin);
        for (int k = part.first; k < from && k < end; ++k)
            part.shares.push_back((std::min(end, k + 1.0) - std::max(begin, double(k))) / step);
    }
    return parts;
}

} // namespace

engine::Image at_most_wide(const engine::Image& image, int width_px) {
    CHECK(width_px >= 1);
    if (image.width <= width_px) return image;
    const int height = std::max(
        1,
        static_cast<int>(std::lround(static_cast<double>(image.height) * width_px / image.width)));
    const std::vector<Part> columns = parts_of(image.width, width_px);
    const std::vector<Part> rows = parts_of(image.height, height);
    engine::Image small(width_px, height, image.channels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width_px; ++x)
            for (int channel = 0; channel < image.channels; ++channel) {
                const Part& row = rows[static_cast<std::size_t>(y)];
                const Part& column = columns[static_cast<std::size_t>(x)];
                double sum = 0.0;
                for (std::size_t v = 0; v < row.shares.size(); ++v)
                    for (std::size_t u = 0; u < column.shares.size(); ++u)
                        sum += row.shares[v] * column.shares[u]
                               * image.at(
                                   column.first + static_cast<int>(u),
                                   row.first + static_cast<int>(v))[channel];
                small.at(x, y)[channel] = static_cast<std::uint8_t>(std::lround(sum));
            }
    return small;
}

std::string png_url(const engine::Image& image) {
    return data_url("image/png", engine::encode_png(image));
}

std::string jpeg_url(const engine::Image& image, int quality) {
    return data_url("image/jpeg", engine::encode_jpeg(image, quality));
}

} // namespace page
