// Made-up points for tests of charts.

#pragma once

#include <string>

#include "tools/chart/chart_page.hpp"

namespace chart_test {

/// With counts over 10000 valid pixels and 500 px of edge.
chart::Point point(const std::string& name, double ms, double wrong_px);

/// A light with none, maps of three sizes, volumes, the truth and two picks of auto; a peer; a
/// refusal; every picture a few pixels large.
chart::Findings findings();

} // namespace chart_test
