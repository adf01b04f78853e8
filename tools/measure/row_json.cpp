#include "tools/measure/row_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace measure {

namespace {

struct TextMember {
    const char* name;
    std::string Row::*member;
};

constexpr TextMember kTexts[] = {
    {"scene", &Row::scene},
    {"camera", &Row::camera},
    {"light", &Row::light},
    {"technique", &Row::technique},
    {"picked", &Row::picked},
    {"protocol", &Row::protocol},
    {"settings", &Row::settings},
    {"renderer", &Row::renderer},
    {"note", &Row::note},
};

/// Calls call(name, member) for each group of figures.
template <class Call>
void each_group(Call call) {
    call("figures", &Row::figures);
    call("motion", &Row::motion);
    call("timing", &Row::timing);
    call("counters", &Row::counters);
}

template <class T>
nlohmann::json group_to_json(const T& group) {
    nlohmann::json json = nlohmann::json::object();
    for (const FigureColumn<T>& column : columns_of<T>()) {
        if (column.access.set == nullptr) continue;
        const Figure figure = column.access.get(group);
        nlohmann::json& value = json[std::string(column.name)];
        if (figure.known())
            value = figure.value();
        else
            value = figure.reason();
    }
    return json;
}

/// @return the figure that is no number or text where one was expected; empty when all are right
template <class T>
std::string read_group(const nlohmann::json& json, T& group) {
    for (const FigureColumn<T>& column : columns_of<T>()) {
        if (column.access.set == nullptr) continue;
        const auto found = json.find(std::string(column.name));
        if (found == json.end()) return std::string(column.name);
        // Members that are plain numbers are always known.
        const bool may_be_missing = !column.access.get(T{}).known();
        if (found->is_number())
            column.access.set(group, found->template get<double>());
        else if (found->is_string() && may_be_missing)
            column.access.set(group, Figure::missing(found->template get<std::string>()));
        else
            return std::string(column.name);
    }
    return {};
}

} // namespace

nlohmann::json to_json(const Row& row) {
    nlohmann::json json = nlohmann::json::object();
    for (const TextMember& text : kTexts)
        json[text.name] = row.*text.member;
    each_group([&](const char* name, auto member) {
        if (row.*member) json[name] = group_to_json(*(row.*member));
    });
    return json;
}

engine::Result<Row> row_from_json(const nlohmann::json& json) {
    Row row;
    std::string wrong;
    for (const TextMember& text : kTexts) {
        const auto found = json.find(text.name);
        if (found == json.end() || !found->is_string())
            return engine::Error{fmt::format("a row without '{}'; expected a text", text.name)};
        row.*text.member = found->get<std::string>();
    }
    each_group([&](const char* name, auto member) {
        const auto found = json.find(name);
        if (found == json.end()) return;
        const std::string missing = read_group(*found, (row.*member).emplace());
        if (!missing.empty()) wrong = fmt::format("{}.{}", name, missing);
    });
    if (!wrong.empty())
        return engine::Error{
            fmt::format("a row without '{}'; expected a number, or a reason why not", wrong)};
    return row;
}

} // namespace measure
