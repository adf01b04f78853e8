#include "tools/chart/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace chart {

namespace {

constexpr std::array<std::string_view, 10> kShapes = {
    "M-4,-4L4,4M-4,4L4,-4",                              // a cross
    "M0,-4.6A4.6,4.6 0 1 1 0,4.6A4.6,4.6 0 1 1 0,-4.6Z", // a disc
    "M-4,-4H4V4H-4Z",                                    // a square
    "M0,-5.8L5.2,0L0,5.8L-5.2,0Z",                       // a diamond
    "M0,-5.4L5.2,4H-5.2Z",                               // a triangle
    "M0,5.4L5.2,-4H-5.2Z",                               // one on its point
    "M0,-6.4L1.6,-2L6.2,-2L2.5,0.8L3.9,5.2L0,2.5L-3.9,5.2L-2.5,0.8L-6.2,-2L-1.6,-2Z", // a star
    "M0,-5.4L5.1,-1.7L3.2,4.4H-3.2L-5.1,-1.7Z",                                       // a pentagon
    "M-1.7,-5H1.7V-1.7H5V1.7H1.7V5H-1.7V1.7H-5V-1.7H-1.7Z",                           // a plus
    "M-5.2,0L-2.6,-4.5H2.6L5.2,0L2.6,4.5H-2.6Z",                                      // a hexagon
};
constexpr std::size_t kPeerShift = 1; ///< no hollow cross

std::size_t place_in(const std::vector<std::string>& names, std::string_view name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

} // namespace

std::string Series::css_class(std::string_view name) const {
    const std::size_t place = place_in(own, name);
    if (place < own.size()) return fmt::format("m{}", place % kShapes.size());
    return fmt::format("q{}", place_in(peers, name));
}

std::string_view Series::shape(std::string_view name) const {
    const std::size_t place = place_in(own, name);
    return place < own.size() ? kShapes[place % kShapes.size()]
                              : kShapes[(place_in(peers, name) + kPeerShift) % kShapes.size()];
}

// Hues after Okabe and Ito, "Color Universal Design", 2008, darkened for paper and lightened for
// the dark so that each has a contrast of at least 3 to 1.
const std::string_view kChartStyle =
    R"css(:root { --c0: #6b6b6b; --c1: #b0508a; --c2: #00805d; --c3: #a06a00; --c4: #c65300; --c5: #0067a3; --c6: #222;
  --c7: #222; --c8: #6a4fb3; --c9: #7a5c3e; --gutter: #00000009; --band: #15803d40; }
@media (prefers-color-scheme: dark) { :root { --c0: #a3a3a3; --c1: #e39ac6; --c2: #2ec49a; --c3: #f0b440;
  --c4: #ff8a3c; --c5: #5ab4e8; --c6: #eee; --c7: #eee; --c8: #b9a3f5; --c9: #cfae8a; --gutter: #ffffff0d;
  --band: #4ade8048; } }
svg.chart { display: block; width: 100%; height: auto; }
svg.chart text { font: 12px system-ui, sans-serif; fill: var(--faint); }
svg.chart text.title { font-size: 14px; font-weight: 600; fill: var(--ink); }
svg.chart text.label { font-size: 10.5px; fill: var(--ink); }
svg.chart .grid { stroke: var(--line); stroke-width: .6; } svg.chart .grid.whole { stroke-width: 1.1; }
svg.chart .frame { fill: none; stroke: var(--faint); } svg.chart .gutter { fill: var(--gutter); }
svg.chart .floor { stroke: var(--bad); stroke-dasharray: 6 4; } svg.chart text.floor-name { font-size: 10.5px; fill: var(--bad); }
svg.chart .front { fill: none; stroke: var(--band); stroke-width: 7; stroke-linejoin: round; }
svg.chart .peer-front { fill: none; stroke: var(--faint); stroke-dasharray: 2 4; }
svg.chart .auto-curve { fill: none; stroke: var(--ink); stroke-width: 1.6; }
svg.chart .family { fill: none; stroke-width: .9; opacity: .55; }
svg.chart .p path { stroke-width: 1.2; } svg.chart .p { cursor: pointer; outline: none; }
svg.chart .p:hover path, svg.chart .p:focus path, svg.chart .p.pinned path { stroke: var(--ink); stroke-width: 2.6; }
svg.chart .key { cursor: pointer; } svg.chart .key text { fill: var(--ink); } svg.chart .key.off { opacity: .35; }
svg.chart .key:focus text { text-decoration: underline; } svg.chart .key { outline: none; }
.m0 { stroke: var(--c0); fill: var(--c0); } .m1 { stroke: var(--c1); fill: var(--c1); }
.m2 { stroke: var(--c2); fill: var(--c2); } .m3 { stroke: var(--c3); fill: var(--c3); }
.m4 { stroke: var(--c4); fill: var(--c4); } .m5 { stroke: var(--c5); fill: var(--c5); }
.m6 { stroke: var(--c6); fill: var(--c6); } .m7 { stroke: var(--c7); fill: var(--c7); }
.m8 { stroke: var(--c8); fill: var(--c8); } .m9 { stroke: var(--c9); fill: var(--c9); }
[class*=" q"] { stroke: var(--faint); fill: none; pointer-events: all; }
svg.chart .key text { stroke: none; } svg.chart .p text { stroke: none; }
)css";

} // namespace chart
