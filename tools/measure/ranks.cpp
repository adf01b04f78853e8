#include "tools/measure/ranks.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace measure {

double mean(const std::vector<float>& values) {
    CHECK(!values.empty());
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double percentile(std::vector<float> values, double part) {
    CHECK(!values.empty());
    const auto count = static_cast<double>(values.size());
    const double rank = std::clamp(std::ceil(part * count), 1.0, count);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
}

} // namespace measure
