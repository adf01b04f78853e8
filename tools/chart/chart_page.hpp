// A page of charts that needs no other file: axes to choose, points that tell what they are when
// one stays on them and show their pictures when they are clicked, a legend that hides series.

#pragma once

#include <string>
#include <vector>

#include "tools/chart/chart.hpp"
#include "tools/chart/marks.hpp"

namespace chart {

/// Everything that a page tells.
struct Findings {
    std::string title;
    std::string about; ///< how it was measured, a paragraph
    Series series;
    std::vector<Chart> charts;
};

std::string chart_page(const Findings& findings);

} // namespace chart
