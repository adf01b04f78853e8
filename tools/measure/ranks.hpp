// Means and percentiles of many numbers.

#pragma once

#include <vector>

namespace measure {

/// @pre not empty
double mean(const std::vector<float>& values);

/// The smallest value that at least `part` of all values do not exceed (nearest rank).
/// @param part 0 to 1
/// @pre not empty
double percentile(std::vector<float> values, double part);

} // namespace measure
