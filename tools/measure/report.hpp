// The results of a run of measurements: one row per scene, camera, light, technique and settings.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tools/measure/columns.hpp"

namespace measure {

/// The protocol in which nothing moves.
inline const std::string kStill = "still";

struct Row {
    std::string scene;
    std::string camera;
    std::string light;
    std::string technique;
    std::string picked;            ///< what auto picked, by share of the valid pixels
    std::string protocol = kStill; ///< what moved while it was measured
    std::string settings;          ///< as one would type them: "--map-size 2048 --filter pcf"
    std::string renderer;          ///< the device's own name
    std::optional<Figures> figures;
    std::optional<MotionFigures> motion;
    std::optional<Timing> timing;
    std::optional<Counters> counters;
    std::string note; ///< why something was not measured; shown as the reason of what is missing
};

using Cell = std::variant<std::string, Figure>;

/// One column of a report.
struct Column {
    std::string_view name;
    std::string_view unit;
    std::string_view text;
    int decimals = 0;        ///< of figures, in the table; kNotInTable leaves the column out there
    std::vector<Cell> cells; ///< one per row
};

class Report {
public:
    void add(Row row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

    /// Every column with its cells, in the order of the files.
    [[nodiscard]] std::vector<Column> columns() const;

    /// Aligned columns for a terminal, under their names and units, a word a line. A figure that is
    /// missing is "-" with a letter, and its reason stands below the table; so do doubts and gates
    /// that were not passed.
    [[nodiscard]] std::string table() const;
    /// RFC 4180; the first line names the columns; a missing figure is an empty field.
    [[nodiscard]] std::string csv() const;
    /// {"columns": [{name, unit, text}], "rows": [{name: value, "missing": {name: reason},
    /// "warnings": []}]}
    [[nodiscard]] nlohmann::json json() const;

private:
    std::vector<Row> rows_;
};

} // namespace measure
