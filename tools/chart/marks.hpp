// What points look like: a shape and a colour for each series. Shapes alone tell them apart, for
// those who do not see colours and on grey paper.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chart {

/// Who has which mark, the same on every chart: the place in the lists decides.
struct Series {
    std::vector<std::string> own;   ///< "none", "planar", ...
    std::vector<std::string> peers; ///< "ogre", "three", ...

    /// CSS classes of a series: "m0" and on, "q0" and on for peers, whose marks are hollow.
    [[nodiscard]] std::string css_class(std::string_view name) const;
    /// The outline of its mark round (0, 0), as an SVG path some 10 px across.
    [[nodiscard]] std::string_view shape(std::string_view name) const;
};

/// CSS of everything that a chart draws, in both colour schemes.
extern const std::string_view kChartStyle;

} // namespace chart
