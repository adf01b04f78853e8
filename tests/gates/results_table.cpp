#include "tests/gates/results_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tools/gnomon/text_files.hpp"

namespace gates {

std::span<const ShownFigure> shown_figures() {
    static const std::vector<ShownFigure> kShown = {
        {"false_shadow_far_px", "false shadow far, px"},
        {"light_leak_far_px", "light leak far, px"},
        {"eps_px", "eps, px"},
        {"changed_px", "changed, px"},
        {"flicker_ratio", "flicker ratio"},
        {"crawl_px", "crawl, px"},
        {"pop", "pop"},
        {"stale_px", "stale, px"}};
    return kShown;
}

std::optional<double>
worst(const Promise& promised, std::span<const measure::Row> rows, const std::string& figure) {
    std::optional<double> largest;
    for (const Gate& gate : promised.gates) {
        if (gate.figure != figure) continue;
        const measure::Figure found = figure_of(row_of(rows, promised, gate.protocol), figure);
        if (found.known()) largest = std::max(largest.value_or(found.value()), found.value());
    }
    return largest;
}

std::optional<double> loosest(const Promise& promised, const std::string& figure) {
    std::optional<double> largest;
    for (const Gate& gate : promised.gates)
        if (gate.figure == figure) largest = std::max(largest.value_or(0.0), gate.at_most);
    return largest;
}

std::string cell(const std::optional<double>& value) {
    if (!value) return "-";
    // Sums of bytes leave what no one reads, and a sign on it.
    constexpr double kNothing = 5e-4;
    return std::abs(*value) < kNothing ? "0" : fmt::format("{:.3g}", *value);
}

MarkdownTable::MarkdownTable(std::vector<std::string> titles) {
    add(titles);
    std::fill(titles.begin(), titles.end(), "---");
    add(titles);
}

void MarkdownTable::add(const std::vector<std::string>& cells) {
    text_ += fmt::format("| {} |\n", fmt::join(cells, " | "));
}

engine::Result<void> keep_result(const std::string& name, const std::string& text) {
    const char* folder = std::getenv("GNOMON_RESULTS");
    if (folder == nullptr) return {};
    return gnomon::write_text(std::filesystem::path(folder) / (name + ".md"), text);
}

} // namespace gates
