#include "tools/measure/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace measure {

namespace {

/// One row or column of a mask, walked by a stride.
struct Line {
    std::size_t first;
    std::size_t stride;
    int count;
};

/// Calls found(i) for each crack between pixels i and i + 1 of the line.
template <class Found>
void walk(const Line& line, const Mask& mask, std::span<const PixelKind> kind, Found found) {
    const auto place = [&](int i) {
        return line.first + static_cast<std::size_t>(i) * line.stride;
    };
    const auto side = [&](int i) { return lit(mask.visibility[place(i)]); };
    for (int i = 0; i + 1 < line.count; ++i) {
        if (kind[place(i)] != PixelKind::valid) continue;
        const PixelKind next = kind[place(i + 1)];
        if (next == PixelKind::valid) {
            if (side(i) != side(i + 1)) found(i);
        } else if (
            next == PixelKind::undecided && i + 2 < line.count
            && kind[place(i + 2)] == PixelKind::valid) {
            if (side(i) != side(i + 2)) found(side(i) != side(i + 1) ? i : i + 1);
        }
    }
}

/// The lower envelope of parabolas, one per place with a finite height, then its value at every
/// place.
class Envelope {
public:
    explicit Envelope(std::size_t count) : heights_(count), vertices_(count), starts_(count + 1) {}

    std::vector<double>& heights() { return heights_; }

    /// Writes the square root of the envelope, halved: half pixels become pixels.
    void write(float* row) {
        const std::size_t kept = build();
        if (kept == 0) return;
        std::size_t at = 0;
        for (std::size_t x = 0; x < heights_.size(); ++x) {
            while (at + 1 < kept && starts_[at + 1] < static_cast<double>(x))
                ++at;
            const double step = static_cast<double>(x) - static_cast<double>(vertices_[at]);
            row[x] = static_cast<float>(0.5 * std::sqrt(step * step + heights_[vertices_[at]]));
        }
    }

private:
    /// Where the parabolas at a < b cross.
    [[nodiscard]] double crossing(std::size_t a, std::size_t b) const {
        const auto square = [](std::size_t v) {
            return static_cast<double>(v) * static_cast<double>(v);
        };
        return (heights_[b] + square(b) - heights_[a] - square(a))
               / (2.0 * static_cast<double>(b - a));
    }

    std::size_t build() {
        std::size_t kept = 0;
        for (std::size_t x = 0; x < heights_.size(); ++x) {
            if (!std::isfinite(heights_[x])) continue;
            while (kept > 0 && crossing(vertices_[kept - 1], x) <= starts_[kept - 1])
                --kept;
            starts_[kept] = kept == 0 ? 0.0 : crossing(vertices_[kept - 1], x);
            vertices_[kept++] = x;
        }
        return kept;
    }

    std::vector<double> heights_; ///< squared distance inside the column
    std::vector<std::size_t> vertices_;
    std::vector<double> starts_; ///< from here on vertex i is the lowest
};

} // namespace

std::vector<Crack> cracks(const Mask& mask, std::span<const PixelKind> kind) {
    std::vector<Crack> found;
    const auto width = static_cast<std::size_t>(mask.width);
    for (int y = 0; y < mask.height; ++y)
        walk({mask.index(0, y), 1, mask.width}, mask, kind, [&](int x) {
            found.push_back({2 * x + 2, 2 * y + 1});
        });
    for (int x = 0; x < mask.width; ++x)
        walk({mask.index(x, 0), width, mask.height}, mask, kind, [&](int y) {
            found.push_back({2 * x + 1, 2 * y + 2});
        });
    return found;
}

double crofton_length(std::size_t crack_count) {
    return std::numbers::pi / 4.0 * static_cast<double>(crack_count);
}

DistanceField::DistanceField(int width, int height, std::span<const Crack> cracks)
    : columns_(2 * static_cast<std::size_t>(width) + 1) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    const std::size_t rows = 2 * static_cast<std::size_t>(height) + 1;
    distance_px_.assign(columns_ * rows, kFar);
    if (cracks.empty()) return;
    for (const Crack& crack : cracks)
        distance_px_
            [static_cast<std::size_t>(crack.y) * columns_ + static_cast<std::size_t>(crack.x)] =
                0.0F;

    // Down and up each column, all columns at once: distance in half pixels within the column.
    for (std::size_t i = columns_; i < distance_px_.size(); ++i)
        distance_px_[i] = std::min(distance_px_[i], distance_px_[i - columns_] + 1.0F);
    for (std::size_t i = distance_px_.size() - columns_; i-- > 0;)
        distance_px_[i] = std::min(distance_px_[i], distance_px_[i + columns_] + 1.0F);

    Envelope envelope(columns_);
    for (std::size_t y = 0; y < rows; ++y) {
        float* row = distance_px_.data() + y * columns_;
        std::transform(row, row + columns_, envelope.heights().begin(), [](float inside) {
            return static_cast<double>(inside) * static_cast<double>(inside);
        });
        envelope.write(row);
    }
}

} // namespace measure
