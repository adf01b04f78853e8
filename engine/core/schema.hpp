// Settings as data: one row per field says what it is called, what it may hold, what it means and
// what it is when nobody says. Readers check against the rows, and editors, manuals and panels are
// made from them, so that a setting is written down in one place.

#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace engine {

enum class FieldType {
    number,
    integer,
    boolean,
    text,    ///< any string
    name,    ///< a string that may name a thing and a file: see is_name()
    choice,  ///< one of Field::words
    words,   ///< one, or a list, of Field::words
    vector,  ///< a list of numbers, Field::min_count to max_count of them
    scale,   ///< like vector, or one number for all of them
    color,   ///< like vector, linear red, green, blue
    table,   ///< the fields of the kind called Field::kind
    points,  ///< a list of places, each a list of three numbers; Field::min_count or more of them
    callback ///< a function
};

/// The numbers that make sense. NaN and infinities never do.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool min_open = false; ///< `min` itself is out of range
    bool max_open = false;

    [[nodiscard]] bool contains(double value) const;
    /// "more than 0", "0 to 90", "at least 0 and less than 90"; empty when everything finite is in
    /// range.
    [[nodiscard]] std::string description() const;
};

/// What a field holds when nobody says: nothing, or a value of its type.
using Fallback = std::variant<std::monostate, double, bool, std::string, std::vector<double>>;

/// One setting.
struct Field {
    std::string name;
    FieldType type = FieldType::number;
    std::string text; ///< one or two sentences: what it is, and what goes wrong at either end
    Fallback fallback = {};
    std::string unit = {}; ///< "m", "deg", "lux"...; empty for bare numbers
    Range range = {};      ///< of numbers and of every component
    int min_count = 3;     ///< of vectors, scales and colours
    int max_count = 3;
    std::vector<std::string> words = {}; ///< allowed ones of choice and words
    std::string kind = {};               ///< of a table
    bool live = false;                   ///< may be read and changed while the level runs
    std::string since = "0.1";           ///< version that brought it
};

/// A table with named fields: a light, a budget.
struct Kind {
    std::string name;
    std::string text; ///< one sentence
    std::vector<Field> fields;
    bool constructed = false; ///< written as g.name { ... }; else a plain table inside another kind
    std::string example = {}; ///< one line of Lua for the manual
    std::string since = "0.1";

    /// Null when there is no such field.
    [[nodiscard]] const Field* find(std::string_view field) const;
    /// For did_you_mean(); views into this kind.
    [[nodiscard]] std::vector<std::string_view> field_names() const;
};

/// All kinds that refer to one another.
struct Schema {
    std::vector<Kind> kinds;

    /// @pre there is such a kind
    [[nodiscard]] const Kind& kind(std::string_view name) const;
};

/// Views of words, for did_you_mean().
std::vector<std::string_view> views_of(std::span<const std::string> words);

/// A name fits into paths and pairs: 1 to 64 bytes of printable text without / \ # " : * ? < > |
/// and not starting with a dot.
bool is_name(std::string_view text);

/// "a number of metres"-like words for messages: "a number", "a list of 3 numbers", "one of \"a\",
/// \"b\"".
std::string expectation(const Field& field);

/// The shortest decimal text that reads back as the same number.
std::string shortest(double number);

} // namespace engine
