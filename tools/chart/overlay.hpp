// Other engines' points, laid over a chart.
//
// They come as a table, CSV (RFC 4180) or JSON (an array of objects), with the columns `scene`,
// `peer`, `config`, `cost` (ms that shadows add to a frame) and `wrong` (percent of the pixels that
// can be judged). `map` (texels per side) is part of a point's name; rows with a `failed` are left
// out; every other column is told with the point.

#pragma once

#include "engine/core/result.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/chart/chart.hpp"

namespace chart {

struct Overlay {
    std::map<std::string, std::vector<Point>> by_scene; ///< points in the file's order
    std::vector<std::string> peers;                     ///< of all scenes, sorted
};

/// @param file its name, for errors; one that ends in .json is JSON
/// Errors: no table; a column that is missing, with those that are there; a cost or a share that is
/// no number, with its row.
engine::Result<Overlay> read_overlay(std::string_view text, const std::string& file);

/// Rows of fields. Source: RFC 4180; a line may end without a carriage return.
std::vector<std::vector<std::string>> csv_rows(std::string_view text);

} // namespace chart
