// Tables of gates for people: figures of a promise, the worst over what moves, in Markdown.

#pragma once

#include "tests/gates/gates.hpp"

#include <optional>

namespace gates {

/// One column: a figure that gates hold.
struct ShownFigure {
    std::string figure; ///< a column of measure::Report
    std::string title;  ///< as people read it, with its unit
};

std::span<const ShownFigure> shown_figures();

/// The largest known value over the protocols in which a promise has a gate for a figure; nothing
/// where it has none.
std::optional<double>
worst(const Promise& promised, std::span<const measure::Row> rows, const std::string& figure);
/// The loosest limit of a figure; nothing where there is no gate.
std::optional<double> loosest(const Promise& promised, const std::string& figure);

/// "-" where there is none; four digits.
std::string cell(const std::optional<double>& value);

/// Rows of cells under a line of titles.
class MarkdownTable {
public:
    explicit MarkdownTable(std::vector<std::string> titles);
    void add(const std::vector<std::string>& cells);
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Writes NAME.md into the folder of GNOMON_RESULTS, where that is set.
/// Errors: the folder does not exist or the disk is full.
engine::Result<void> keep_result(const std::string& name, const std::string& text);

} // namespace gates
