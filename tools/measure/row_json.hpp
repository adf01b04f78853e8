// A row as JSON and back, losing nothing: for rows that are kept while others are still measured.
// Reports are written by Report::json(), which people read.

#pragma once

#include "engine/core/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include "tools/measure/report.hpp"

namespace measure {

/// {"scene": text, ..., "figures": {name: number, or the reason why there is none}, "motion": ...}
/// with the names of the report's columns; a group that was not measured is left out.
nlohmann::json to_json(const Row& row);

/// What to_json() was given. Errors: a name or a value that is missing or of another kind.
engine::Result<Row> row_from_json(const nlohmann::json& json);

} // namespace measure
