#include "tools/chart/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "tools/chart/pareto.hpp"

namespace chart {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeader =
    "scene,light,point,series,peer,measured_ms,predicted_ms,wrong_percent,eps_px,error_px,"
    "budget_px,front\r\n";

/// Times decide where there are any.
Across usual(const Chart& chart) {
    return std::any_of(
               chart.points.begin(),
               chart.points.end(),
               [](const Point& point) { return point.measured_ms.has_value(); })
               ? Across::measured
               : Across::predicted;
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string safe = "\"";
    for (const char letter : text) {
        if (letter == '"') safe += '"';
        safe += letter;
    }
    return safe + '"';
}

std::string number(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string();
}

Json json_number(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

} // namespace

std::string csv(std::span<const Chart> charts) {
    std::string text = kHeader;
    for (const Chart& chart : charts) {
        const std::vector<bool> front = on_front(chart, usual(chart), usual_up({&chart, 1}));
        const std::vector<const Point*> all = chart.all();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Point& point = *all[i];
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{},{}\r\n",
                quoted(chart.scene),
                quoted(chart.light),
                quoted(point.name),
                quoted(point.series),
                i < chart.points.size() ? 0 : 1,
                number(point.measured_ms),
                number(point.predicted_ms),
                number(value(point, Up::wrong_percent)),
                number(value(point, Up::eps_px)),
                number(value(point, Up::error_px)),
                number(point.budget_px),
                front[i] ? 1 : 0);
        }
    }
    return text;
}

std::string json(std::span<const Chart> charts) {
    Json result = {{"charts", Json::array()}};
    for (const Chart& chart : charts) {
        Json one = {{"scene", chart.scene}, {"light", chart.light}};
        for (const Up up : kUp)
            for (const Floor& floor : floors(chart, up))
                one["floors"][std::string(word_of(up))][floor.name] = floor.value;
        const std::vector<bool> front = on_front(chart, usual(chart), usual_up({&chart, 1}));
        const std::vector<const Point*> all = chart.all();
        one["points"] = Json::array();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Point& point = *all[i];
            Json row = {
                {"point", point.name},
                {"series", point.series},
                {"peer", i >= chart.points.size()},
                {"measured_ms", json_number(point.measured_ms)},
                {"predicted_ms", json_number(point.predicted_ms)}};
            for (const Up up : kUp)
                row[std::string(word_of(up))] = json_number(value(point, up));
            row["budget_px"] = json_number(point.budget_px);
            row["front"] = static_cast<bool>(front[i]);
            for (const auto& [name, text] : point.facts)
                row["facts"][name] = text;
            one["points"].push_back(std::move(row));
        }
        one["refusals"] = Json::array();
        for (const Refusal& refusal : chart.refusals)
            one["refusals"].push_back({{"name", refusal.name}, {"reason", refusal.reason}});
        result["charts"].push_back(std::move(one));
    }
    return result.dump(1) + "\n";
}

} // namespace chart
