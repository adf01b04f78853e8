// The report as a person reads it in a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tools/measure/report.hpp"

namespace measure {

namespace {

/// Reasons for what is missing, each told once, under a mark of its own: a, b, ... z, aa, ab.
class Notes {
public:
    std::string mark_for(const std::string& reason) {
        auto place = std::find(reasons_.begin(), reasons_.end(), reason);
        if (place == reasons_.end()) place = reasons_.insert(reasons_.end(), reason);
        return mark(place - reasons_.begin());
    }

    [[nodiscard]] std::string text() const {
        std::string result;
        for (std::size_t i = 0; i < reasons_.size(); ++i)
            result += fmt::format("-{}  {}\n", mark(static_cast<std::ptrdiff_t>(i)), reasons_[i]);
        return result;
    }

private:
    static std::string mark(std::ptrdiff_t index) {
        const std::string last(1, static_cast<char>('a' + index % 26));
        return index < 26 ? last : mark(index / 26 - 1) + last;
    }

    std::vector<std::string> reasons_;
};

/// The words of a column's name, and its unit: one a line, so that columns stay narrow.
std::vector<std::string> heading(const Column& column) {
    std::vector<std::string> words(1);
    for (const char letter : column.name) {
        if (letter == '_')
            words.emplace_back();
        else
            words.back() += letter;
    }
    if (words.back() == column.unit) words.pop_back();
    words.emplace_back(column.unit);
    return words;
}

/// A column as text: its heading, then one line per row.
struct TextColumn {
    std::vector<std::string> lines;
    std::size_t width = 0;
    bool left = false; ///< words stand left, numbers right
};

TextColumn text_column(const Column& column, std::size_t heading_lines, Notes& notes) {
    TextColumn result;
    result.lines = heading(column);
    result.lines.insert(result.lines.begin(), heading_lines - result.lines.size(), std::string());
    for (const Cell& cell : column.cells) {
        if (const auto* text = std::get_if<std::string>(&cell)) {
            result.left = true;
            result.lines.push_back(*text);
        } else if (const auto& figure = std::get<Figure>(cell); figure.known()) {
            result.lines.push_back(fmt::format("{:.{}f}", figure.value(), column.decimals));
        } else {
            result.lines.push_back("-" + notes.mark_for(figure.reason()));
        }
    }
    for (const std::string& line : result.lines)
        result.width = std::max(result.width, line.size());
    return result;
}

} // namespace

std::string Report::table() const {
    std::vector<Column> shown = columns();
    std::erase_if(shown, [](const Column& column) { return column.decimals == kNotInTable; });
    std::size_t heading_lines = 0;
    for (const Column& column : shown)
        heading_lines = std::max(heading_lines, heading(column).size());
    Notes notes;
    std::vector<TextColumn> texts;
    for (const Column& column : shown)
        texts.push_back(text_column(column, heading_lines, notes));

    std::string result;
    for (std::size_t line = 0; line < heading_lines + rows_.size(); ++line) {
        std::string row;
        for (const TextColumn& column : texts) {
            const char* const format = column.left ? "{:<{}}  " : "{:>{}}  ";
            row += fmt::format(fmt::runtime(format), column.lines[line], column.width);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        result += row + '\n';
    }
    result += notes.text();
    for (const Row& row : rows_) {
        if (!row.figures) continue;
        for (const std::string& doubt : warnings(*row.figures))
            result +=
                fmt::format("!  {}, {}, {}: {}\n", row.scene, row.light, row.technique, doubt);
    }
    return result;
}

} // namespace measure
