#include "engine/script/table_reader.hpp"

#include "engine/core/check.hpp"
#include "engine/core/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace script {

using engine::Field;
using engine::FieldType;

namespace {

const Value* find_field(const Table& table, std::string_view name) {
    const auto found = std::lower_bound(
        table.fields.begin(),
        table.fields.end(),
        name,
        [](const auto& field, std::string_view wanted) { return field.first < wanted; });
    return found != table.fields.end() && found->first == name ? &found->second : nullptr;
}

/// " m", " deg" or nothing.
std::string unit_of(const Field& field) {
    return field.unit.empty() ? "" : " " + field.unit;
}

bool looks_like_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789.+-eE") == std::string::npos;
}

} // namespace

TableReader::TableReader(
    const Table& table,
    const engine::Schema& schema,
    std::string_view kind,
    Report& report,
    Subject subject)
    : table_(table),
      schema_(schema),
      kind_(schema.kind(kind)),
      report_(report),
      subject_(std::move(subject)) {}

const Field& TableReader::row(std::string_view field) const {
    const Field* row = kind_.find(field);
    if (row == nullptr)
        engine::check_failed(__FILE__, __LINE__, "field is in the schema", std::string(field));
    return *row;
}

bool TableReader::has(std::string_view field) const {
    return find_field(table_, field) != nullptr;
}

const Value* TableReader::find(std::string_view field, FieldType first, FieldType last) {
    const FieldType type = row(field).type;
    CHECK(first <= type && type <= last);
    asked_.emplace(field);
    return find_field(table_, field);
}

void TableReader::complain(std::string_view field, const std::string& complaint) {
    report_.error(subject_, std::string(field), complaint);
}

void TableReader::complain_about_type(const Field& field, const Value& value) {
    std::string hint;
    const bool numeric = field.type == FieldType::number || field.type == FieldType::integer;
    if (numeric && value.type == Value::Type::text && looks_like_number(value.text))
        hint = "; write it without quotes";
    complain(
        field.name,
        fmt::format("is {}, expected {}{}", value.description(), engine::expectation(field), hint));
}

std::optional<double> TableReader::checked(const Field& field, const Value& value) {
    if (value.type != Value::Type::number) {
        complain_about_type(field, value);
        return std::nullopt;
    }
    if (field.type == FieldType::integer && value.number != std::floor(value.number)) {
        complain_about_type(field, value);
        return std::nullopt;
    }
    if (field.range.contains(value.number)) return value.number;
    const std::string range = field.range.description();
    complain(
        field.name,
        fmt::format(
            "is {}{}, expected {}{}",
            engine::shortest(value.number),
            std::isfinite(value.number) ? unit_of(field) : "",
            range.empty() ? "a finite number" : range,
            range.empty() ? "" : unit_of(field)));
    return std::nullopt;
}

std::optional<double> TableReader::optional_number(std::string_view field) {
    const Value* value = find(field, FieldType::number, FieldType::integer);
    return value == nullptr ? std::nullopt : checked(row(field), *value);
}

std::optional<int> TableReader::optional_integer(std::string_view field) {
    const std::optional<double> number = optional_number(field);
    return number ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
}

double TableReader::number(std::string_view field) {
    return optional_number(field).value_or(std::get<double>(row(field).fallback));
}

bool TableReader::boolean(std::string_view field) {
    const Value* value = find(field, FieldType::boolean, FieldType::boolean);
    if (value != nullptr && value->type == Value::Type::boolean) return value->boolean;
    if (value != nullptr) complain_about_type(row(field), *value);
    return std::get<bool>(row(field).fallback);
}

bool TableReader::is_word(const Field& field, const Value& value) {
    if (value.type != Value::Type::text) {
        complain_about_type(field, value);
        return false;
    }
    if (std::find(field.words.begin(), field.words.end(), value.text) != field.words.end())
        return true;
    const std::string nearest = engine::did_you_mean(value.text, engine::views_of(field.words));
    complain(
        field.name,
        fmt::format(
            "is {}, expected {}{}", value.description(), engine::expectation(field), nearest));
    return false;
}

std::optional<std::string> TableReader::text(std::string_view field) {
    const Value* value = find(field, FieldType::text, FieldType::choice);
    if (value == nullptr) return std::nullopt;
    const Field& wanted = row(field);
    if (wanted.type == FieldType::choice)
        return is_word(wanted, *value) ? std::optional(value->text) : std::nullopt;
    const bool is_text = value->type == Value::Type::text;
    if (is_text && (wanted.type != FieldType::name || engine::is_name(value->text)))
        return value->text;
    complain_about_type(wanted, *value);
    return std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::words(std::string_view field) {
    const Value* value = find(field, FieldType::words, FieldType::words);
    if (value == nullptr) return std::nullopt;
    const Field& wanted = row(field);
    if (value->type != Value::Type::table)
        return is_word(wanted, *value) ? std::optional(std::vector{value->text}) : std::nullopt;
    std::vector<std::string> words;
    for (const Value& word : value->table->list)
        if (is_word(wanted, word)) words.push_back(word.text);
    if (!value->table->fields.empty() || !value->table->strays.empty())
        complain(field, "has named fields, expected a list of words");
    return words;
}

std::optional<std::vector<double>> TableReader::numbers(std::string_view field) {
    const Value* value = find(field, FieldType::vector, FieldType::color);
    if (value == nullptr) return std::nullopt;
    const Field& wanted = row(field);
    if (wanted.type == FieldType::scale && value->type == Value::Type::number) {
        const auto factor = checked(wanted, *value);
        return factor ? std::optional(std::vector<double>(3, *factor)) : std::nullopt;
    }
    if (value->type != Value::Type::table) {
        complain_about_type(wanted, *value);
        return std::nullopt;
    }
    const Table& given = *value->table;
    if (!given.fields.empty() || !given.strays.empty()) {
        const std::string key =
            given.fields.empty() ? given.strays.front() : given.fields.front().first;
        complain(
            field, fmt::format("has a field '{}', expected {}", key, engine::expectation(wanted)));
        return std::nullopt;
    }
    const auto count = static_cast<int>(given.list.size());
    if (count < wanted.min_count || count > wanted.max_count) {
        complain(
            field, fmt::format("has {} values, expected {}", count, engine::expectation(wanted)));
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (const Value& component : given.list)
        if (const auto number = checked(wanted, component)) numbers.push_back(*number);
    return numbers.size() == given.list.size() ? std::optional(numbers) : std::nullopt;
}

std::vector<glm::dvec3> TableReader::points(std::string_view field) {
    const Value* value = find(field, FieldType::points, FieldType::points);
    if (value == nullptr) return {};
    const Field& wanted = row(field);
    const bool is_list = value->type == Value::Type::table && value->table->fields.empty()
                         && value->table->strays.empty()
                         && static_cast<int>(value->table->list.size()) >= wanted.min_count;
    std::vector<glm::dvec3> points;
    for (const Value& point : is_list ? value->table->list : std::vector<Value>()) {
        if (point.type != Value::Type::table || point.table->list.size() != 3) break;
        glm::dvec3& made = points.emplace_back();
        for (int i = 0; i < 3; ++i) {
            const auto number = checked(wanted, point.table->list[static_cast<std::size_t>(i)]);
            if (!number) return {};
            made[i] = *number;
        }
    }
    if (is_list && points.size() == value->table->list.size()) return points;
    complain_about_type(wanted, *value);
    return {};
}

bool TableReader::callback(std::string_view field) {
    const Value* value = find(field, FieldType::callback, FieldType::callback);
    if (value == nullptr) return false;
    if (value->type == Value::Type::other && value->text == "function") return true;
    complain_about_type(row(field), *value);
    return false;
}

glm::dvec3 TableReader::default_vector(std::string_view field) const {
    const auto* fallback = std::get_if<std::vector<double>>(&row(field).fallback);
    return fallback != nullptr ? glm::dvec3((*fallback)[0], (*fallback)[1], (*fallback)[2])
                               : glm::dvec3(0.0);
}

glm::dvec3 TableReader::vector(std::string_view field) {
    CHECK_EQ(row(field).min_count, 3);
    const auto given = numbers(field);
    return given ? glm::dvec3((*given)[0], (*given)[1], (*given)[2]) : default_vector(field);
}

TableReader TableReader::table(std::string_view field) {
    static const Table empty;
    const Value* value = find(field, FieldType::table, FieldType::table);
    const bool usable = value != nullptr && value->type == Value::Type::table;
    if (value != nullptr && !usable) complain_about_type(row(field), *value);
    return {
        usable ? *value->table : empty,
        schema_,
        row(field).kind,
        report_,
        subject_.inside(std::string(field))};
}

void TableReader::call_it(const std::string& name) {
    subject_.title = fmt::format("{} \"{}\"", kind_.name, name);
}

void TableReader::finish() {
    for (const Field& field : kind_.fields)
        if (!asked_.contains(field.name))
            engine::check_failed(
                __FILE__, __LINE__, "every field is read", kind_.name + "." + field.name);
    const std::vector<std::string_view> names = kind_.field_names();
    for (const auto& [name, value] : table_.fields) {
        if (asked_.contains(name)) continue;
        std::string hint = engine::did_you_mean(name, names);
        if (hint.empty()) hint = fmt::format("; the fields are {}", fmt::join(names, ", "));
        complain(name, "is no field" + hint);
    }
    for (const std::string& key : table_.strays)
        complain("", fmt::format("[{}] is no field; fields have names", key));
    if (!kind_.constructed || kind_.name != "scene")
        if (!table_.list.empty())
            complain(
                "",
                fmt::format(
                    "has a value without a name, {}; write name = value",
                    table_.list.front().description()));
}

} // namespace script
