#include "tools/measure/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace measure {

namespace {

void put(nlohmann::json& object, std::string_view name, const Figure& figure) {
    const std::string key(name);
    if (figure.known()) {
        object[key] = figure.value();
    } else {
        object[key] = nullptr;
        object["missing"][key] = figure.reason();
    }
}

template <class T>
nlohmann::json figures_to_json(const T& group) {
    nlohmann::json object = nlohmann::json::object();
    for (const FigureColumn<T>& column : columns_of<T>())
        put(object, column.name, column.access.get(group));
    return object;
}

void add_texts(const std::vector<Row>& rows, std::vector<Column>& columns) {
    struct TextColumn {
        std::string_view name;
        std::string_view text;
        int decimals;
        std::string Row::*member;
    };
    static constexpr TextColumn kTexts[] = {
        {"scene", "the file", 0, &Row::scene},
        {"camera", "its camera", 0, &Row::camera},
        {"light", "the light whose mask is measured", 0, &Row::light},
        {"technique", "what drew the shadow", 0, &Row::technique},
        {"settings", "other than the default", 0, &Row::settings},
        {"renderer", "the device", kNotInTable, &Row::renderer},
        {"note", "why something was not measured", kNotInTable, &Row::note},
        {"picked", "what auto picked, shares of the valid pixels", 0, &Row::picked},
        {"protocol", "what moved", 0, &Row::protocol},
    };
    for (const TextColumn& text : kTexts) {
        Column column = {text.name, "", text.text, text.decimals, {}};
        for (const Row& row : rows)
            column.cells.emplace_back(row.*text.member);
        columns.push_back(std::move(column));
    }
}

template <class T>
void add_figures(
    const std::vector<Row>& rows, std::optional<T> Row::*group, std::vector<Column>& columns) {
    for (const FigureColumn<T>& figure : columns_of<T>()) {
        Column column = {figure.name, figure.unit, figure.text, figure.decimals, {}};
        for (const Row& row : rows) {
            const std::optional<T>& values = row.*group;
            const Figure missing = row.note.empty() ? Figure() : Figure::missing(row.note);
            column.cells.emplace_back(values ? figure.access.get(*values) : missing);
        }
        columns.push_back(std::move(column));
    }
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"') result += '"';
        result += letter;
    }
    return result + '"';
}

std::string csv_field(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return quoted(*text);
    const Figure& figure = std::get<Figure>(cell);
    return figure.known() ? fmt::format("{}", figure.value()) : std::string();
}

} // namespace

nlohmann::json to_json(const Figures& figures) {
    return figures_to_json(figures);
}

nlohmann::json to_json(const MotionFigures& figures) {
    return figures_to_json(figures);
}

std::vector<Column> Report::columns() const {
    std::vector<Column> columns;
    add_texts(rows_, columns);
    add_figures(rows_, &Row::figures, columns);
    add_figures(rows_, &Row::motion, columns);
    add_figures(rows_, &Row::timing, columns);
    add_figures(rows_, &Row::counters, columns);
    return columns;
}

std::string Report::csv() const {
    const std::vector<Column> all = columns();
    std::string text;
    for (const Column& column : all)
        text += fmt::format("{}{}", &column == all.data() ? "" : ",", column.name);
    text += "\r\n";
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        for (const Column& column : all)
            text +=
                fmt::format("{}{}", &column == all.data() ? "" : ",", csv_field(column.cells[row]));
        text += "\r\n";
    }
    return text;
}

nlohmann::json Report::json() const {
    nlohmann::json result = {
        {"columns", nlohmann::json::array()}, {"rows", nlohmann::json::array()}};
    for (const Row& row : rows_) {
        const std::vector<std::string> doubts =
            row.figures ? warnings(*row.figures) : std::vector<std::string>();
        result["rows"].push_back({{"warnings", doubts}});
    }
    for (const Column& column : columns()) {
        const std::string name(column.name);
        result["columns"].push_back({{"name", name}, {"unit", column.unit}, {"text", column.text}});
        for (std::size_t i = 0; i < column.cells.size(); ++i) {
            nlohmann::json& row = result["rows"][i];
            if (const auto* text = std::get_if<std::string>(&column.cells[i])) {
                row[name] = *text;
            } else {
                put(row, column.name, std::get<Figure>(column.cells[i]));
            }
        }
    }
    return result;
}

} // namespace measure
