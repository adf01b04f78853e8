#include "tools/chart/overlay.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace chart {

namespace {

constexpr std::array<std::string_view, 5> kNeeded = {"scene", "peer", "config", "cost", "wrong"};
constexpr std::array<std::string_view, 7> kNoFacts = {
    "scene", "peer", "config", "map", "cost", "wrong", "failed"};

using Fields = std::vector<std::pair<std::string, std::string>>; ///< column and value

std::string field(const Fields& fields, std::string_view column) {
    const auto found = std::find_if(
        fields.begin(), fields.end(), [&](const auto& one) { return one.first == column; });
    return found == fields.end() ? std::string() : found->second;
}

std::optional<double> number(const std::string& text) {
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && end == text.data() + text.size() && std::isfinite(value)
               ? std::optional(value)
               : std::nullopt;
}

engine::Result<std::vector<Fields>> from_csv(std::string_view text) {
    const auto rows = csv_rows(text);
    if (rows.empty()) return engine::Error{"the file is empty; expected a table with a header"};
    std::vector<Fields> table;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].size() != rows[0].size())
            return engine::Error{fmt::format(
                "row {} has {} fields, its header {}", i + 1, rows[i].size(), rows[0].size())};
        Fields& fields = table.emplace_back();
        for (std::size_t k = 0; k < rows[0].size(); ++k)
            fields.emplace_back(rows[0][k], rows[i][k]);
    }
    if (table.empty()) return engine::Error{"the table has a header and no rows"};
    return table;
}

engine::Result<std::vector<Fields>> from_json(std::string_view text) {
    const auto parsed = nlohmann::json::parse(text, nullptr, false);
    if (!parsed.is_array() || parsed.empty())
        return engine::Error{"expected a JSON array of objects, one a point"};
    std::vector<Fields> table;
    for (const nlohmann::json& row : parsed) {
        if (!row.is_object()) return engine::Error{"expected a JSON array of objects, one a point"};
        Fields& fields = table.emplace_back();
        for (const auto& [key, value] : row.items())
            fields.emplace_back(
                key,
                value.is_string() ? value.get<std::string>()
                : value.is_null() ? ""
                                  : value.dump());
    }
    return table;
}

engine::Result<Point> point_of(const Fields& fields, std::size_t row) {
    for (const std::string_view column : kNeeded)
        if (std::none_of(fields.begin(), fields.end(), [&](const auto& one) {
                return one.first == column;
            })) {
            std::vector<std::string> there;
            for (const auto& [name, value] : fields)
                there.push_back(name);
            return engine::Error{fmt::format(
                "column '{}' is missing; expected {}; found {}",
                column,
                fmt::join(kNeeded, ", "),
                fmt::join(there, ", "))};
        }
    Point point;
    point.series = field(fields, "peer");
    point.name = fmt::format("{} {}", point.series, field(fields, "config"));
    point.family = point.name;
    if (const std::string map = field(fields, "map"); !map.empty() && map != "0")
        point.name += " " + map;
    point.measured_ms = number(field(fields, "cost"));
    point.wrong_percent = number(field(fields, "wrong"));
    if (!point.measured_ms || !point.wrong_percent)
        return engine::Error{fmt::format(
            "row {}: '{}' or '{}' is no number; expected cost in ms and wrong in percent",
            row,
            field(fields, "cost"),
            field(fields, "wrong"))};
    for (const auto& [column, value] : fields)
        if (!value.empty() && std::find(kNoFacts.begin(), kNoFacts.end(), column) == kNoFacts.end())
            point.facts.emplace_back(column, value);
    return point;
}

} // namespace

std::vector<std::vector<std::string>> csv_rows(std::string_view text) {
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> row(1);
    bool quoted = false;
    const auto end_row = [&] {
        if (row.size() > 1 || !row[0].empty()) rows.push_back(std::move(row));
        row.assign(1, "");
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (quoted && letter == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            row.back() += '"';
            ++i;
        } else if (letter == '"') {
            quoted = !quoted;
        } else if (quoted) {
            row.back() += letter;
        } else if (letter == ',') {
            row.emplace_back();
        } else if (letter == '\n') {
            end_row();
        } else if (letter != '\r') {
            row.back() += letter;
        }
    }
    end_row();
    return rows;
}

engine::Result<Overlay> read_overlay(std::string_view text, const std::string& file) {
    const auto table = file.ends_with(".json") ? from_json(text) : from_csv(text);
    if (!table) return engine::Error{table.error().message, {file}};
    Overlay overlay;
    std::set<std::string> peers;
    for (std::size_t i = 0; i < table->size(); ++i) {
        const Fields& fields = (*table)[i];
        if (!field(fields, "failed").empty()) continue;
        const auto point = point_of(fields, i + 2);
        if (!point) return engine::Error{point.error().message, {file}};
        peers.insert(point->series);
        overlay.by_scene[field(fields, "scene")].push_back(*point);
    }
    overlay.peers.assign(peers.begin(), peers.end());
    return overlay;
}

} // namespace chart
