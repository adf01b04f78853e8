// Reads one table of a level as its kind asks. Whatever is wrong is reported and read as the
// default, so that one pass finds every mistake; what nobody asked for is a mistake too.

#pragma once

#include "engine/core/schema.hpp"
#include "engine/script/report.hpp"
#include "engine/script/value.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace script {

/// Fields are named as in the schema.
/// @pre of every reading function: the kind has such a field, of such a type
class TableReader {
public:
    /// All four must outlive the reader.
    TableReader(
        const Table& table,
        const engine::Schema& schema,
        std::string_view kind,
        Report& report,
        Subject subject);

    /// Whether the level says anything about it.
    [[nodiscard]] bool has(std::string_view field) const;

    /// The value, or the default. @pre the field has a default
    double number(std::string_view field);
    bool boolean(std::string_view field);
    /// Vectors, scales and colours of three numbers; zero where the field has no default.
    glm::dvec3 vector(std::string_view field);
    [[nodiscard]] glm::dvec3 default_vector(std::string_view field) const;

    /// The value, if it is there and right.
    std::optional<double> optional_number(std::string_view field);
    std::optional<int> optional_integer(std::string_view field);
    /// Texts, names and choices.
    std::optional<std::string> text(std::string_view field);
    std::optional<std::vector<std::string>> words(std::string_view field);
    /// As many numbers as were given.
    std::optional<std::vector<double>> numbers(std::string_view field);
    /// Places; empty when there are none, or wrong ones.
    std::vector<glm::dvec3> points(std::string_view field);
    /// Whether the field holds a function.
    bool callback(std::string_view field);
    /// The table in a field; an empty one when there is none.
    TableReader table(std::string_view field);

    /// Names the thing in messages from now on: sun "noon".
    void call_it(const std::string& name);
    [[nodiscard]] const Subject& subject() const { return subject_; }

    /// Reports a mistake about a field.
    void complain(std::string_view field, const std::string& complaint);

    /// Reports the fields that nobody asked for. @pre every field of the kind was asked for
    void finish();

private:
    /// Null when absent. Remembers that it was asked for.
    const Value* find(std::string_view field, engine::FieldType first, engine::FieldType last);
    void complain_about_type(const engine::Field& field, const Value& value);
    std::optional<double> checked(const engine::Field& field, const Value& value);
    bool is_word(const engine::Field& field, const Value& value);
    [[nodiscard]] const engine::Field& row(std::string_view field) const;

    const Table& table_;
    const engine::Schema& schema_;
    const engine::Kind& kind_;
    Report& report_;
    Subject subject_;
    std::set<std::string, std::less<>> asked_;
};

} // namespace script
