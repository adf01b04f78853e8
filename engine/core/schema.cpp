#include "engine/core/schema.hpp"

#include "engine/core/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace engine {

bool Range::contains(double value) const {
    if (!std::isfinite(value)) return false;
    const bool above = min_open ? value > min : value >= min;
    const bool below = max_open ? value < max : value <= max;
    return above && below;
}

std::string Range::description() const {
    const std::string low =
        std::isinf(min) ? ""
                        : fmt::format("{} {}", min_open ? "more than" : "at least", shortest(min));
    const std::string high =
        std::isinf(max) ? ""
                        : fmt::format("{} {}", max_open ? "less than" : "at most", shortest(max));
    if (low.empty() || high.empty()) return low + high;
    if (!min_open && !max_open) return fmt::format("{} to {}", shortest(min), shortest(max));
    return fmt::format("{} and {}", low, high);
}

const Field* Kind::find(std::string_view field) const {
    const auto found = std::find_if(
        fields.begin(), fields.end(), [&](const Field& row) { return row.name == field; });
    return found == fields.end() ? nullptr : &*found;
}

std::vector<std::string_view> Kind::field_names() const {
    std::vector<std::string_view> names;
    for (const Field& field : fields)
        names.push_back(field.name);
    return names;
}

const Kind& Schema::kind(std::string_view name) const {
    const auto found = std::find_if(
        kinds.begin(), kinds.end(), [&](const Kind& candidate) { return candidate.name == name; });
    if (found == kinds.end()) check_failed(__FILE__, __LINE__, "kind exists", std::string(name));
    return *found;
}

std::vector<std::string_view> views_of(std::span<const std::string> words) {
    return {words.begin(), words.end()};
}

bool is_name(std::string_view text) {
    if (text.empty() || text.size() > 64 || text.front() == '.') return false;
    return std::none_of(text.begin(), text.end(), [](char letter) {
        const auto byte = static_cast<unsigned char>(letter);
        return byte < 0x20 || byte == 0x7F
               || std::string_view("/\\#\":*?<>|").find(letter) != std::string_view::npos;
    });
}

namespace {

std::string count_of_numbers(const Field& field) {
    if (field.min_count == field.max_count) return fmt::format("{} numbers", field.min_count);
    return fmt::format("{} to {} numbers", field.min_count, field.max_count);
}

} // namespace

std::string expectation(const Field& field) {
    switch (field.type) {
    case FieldType::number:
        return "a number";
    case FieldType::integer:
        return "a whole number";
    case FieldType::boolean:
        return "true or false";
    case FieldType::text:
        return "a string";
    case FieldType::name:
        return "a name: up to 64 letters, digits, spaces, - or _ (no / \\ # \" : * ? < > |)";
    case FieldType::choice:
        return fmt::format("one of \"{}\"", fmt::join(field.words, "\", \""));
    case FieldType::words:
        return fmt::format("one or a list of \"{}\"", fmt::join(field.words, "\", \""));
    case FieldType::vector:
    case FieldType::color:
        return "a list of " + count_of_numbers(field);
    case FieldType::scale:
        return "a number or a list of " + count_of_numbers(field);
    case FieldType::table:
        return "a table";
    case FieldType::points:
        return fmt::format(
            "a list of {} or more places, each a list of 3 numbers", field.min_count);
    case FieldType::callback:
        return "a function";
    }
    return {};
}

std::string shortest(double number) {
    if (number == std::floor(number) && std::abs(number) < 1e15)
        return fmt::format("{:.0f}", number);
    return fmt::format("{}", number);
}

} // namespace engine
