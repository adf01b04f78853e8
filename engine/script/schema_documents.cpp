#include "engine/script/schema_documents.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <vector>

namespace script {

namespace {

using engine::Field;
using engine::FieldType;
using engine::Kind;
using engine::Schema;

constexpr const char* kMade =
    "made from engine/script/scene_schema.cpp; GNOMON_UPDATE=1 engine_script_tests writes it anew";

/// A LuaCATS type.
std::string lua_type_of(const Field& field) {
    const std::string words = fmt::format("\"{}\"", fmt::join(field.words, "\"|\""));
    switch (field.type) {
    case FieldType::number:
        return "number";
    case FieldType::integer:
        return "integer";
    case FieldType::boolean:
        return "boolean";
    case FieldType::text:
    case FieldType::name:
        return "string";
    case FieldType::choice:
        return words;
    case FieldType::words:
        return fmt::format("{0}|({0})[]", words);
    case FieldType::vector:
    case FieldType::color:
        return "number[]";
    case FieldType::scale:
        return "number|number[]";
    case FieldType::points:
        return "number[][]";
    case FieldType::callback:
        return "fun(dt: number)";
    case FieldType::table:
        return "gnomon." + field.kind;
    }
    return {};
}

std::string default_text(const Field& field) {
    struct Writer {
        std::string operator()(std::monostate /*nothing*/) const { return ""; }
        std::string operator()(double number) const { return engine::shortest(number); }
        std::string operator()(bool truth) const { return truth ? "true" : "false"; }
        std::string operator()(const std::string& text) const { return "\"" + text + "\""; }
        std::string operator()(const std::vector<double>& numbers) const {
            std::vector<std::string> texts;
            for (const double number : numbers)
                texts.push_back(engine::shortest(number));
            return fmt::format("{{{}}}", fmt::join(texts, ", "));
        }
    };
    return std::visit(Writer{}, field.fallback);
}

/// "0 to 90 deg", "a list of 3 numbers, m": what a field may hold.
std::string value_text(const Field& field) {
    std::string text = engine::expectation(field);
    const bool numeric = field.type == FieldType::number || field.type == FieldType::integer;
    const std::string range = field.range.description();
    if (numeric && !range.empty())
        text = field.type == FieldType::integer ? "a whole number, " + range : range;
    if (!numeric && !range.empty()) text += ", each " + range;
    return field.unit.empty() ? text : text + " " + field.unit;
}

std::string annotation_of(const Field& field) {
    const std::string fallback = default_text(field);
    return fmt::format(
        "---@field {}? {} {} ({}{})\n",
        field.name,
        lua_type_of(field),
        field.text,
        value_text(field),
        fallback.empty() ? "" : "; default " + fallback);
}

std::string escaped_for_table(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
        text.insert(at, "\\");
    return text;
}

std::string reference_of(const Kind& kind) {
    std::string page = fmt::format("\n## {}\n\n{}\n\n", kind.name, kind.text);
    if (!kind.example.empty()) page += fmt::format("```lua\n{}\n```\n\n", kind.example);
    page += "| field | value | default | what it is |\n|---|---|---|---|\n";
    for (const Field& field : kind.fields) {
        const std::string value = field.type == FieldType::table
                                      ? fmt::format("[{0}](#{0})", field.kind)
                                      : value_text(field);
        page += fmt::format(
            "| `{}` | {} | {} | {} |\n",
            field.name,
            escaped_for_table(value),
            default_text(field),
            escaped_for_table(field.text));
    }
    return page;
}

/// Every live field once: a handle may be of any kind.
std::string handle_annotations(const Schema& schema) {
    std::string text = "\n---Something in a running level, found by its name.\n---@class (exact) "
                       "gnomon.handle\n---@field name string What it is called; cannot be set.\n";
    std::set<std::string> told;
    for (const Kind& kind : schema.kinds)
        for (const Field& field : kind.fields)
            if (field.live && told.insert(field.name).second)
                text += fmt::format(
                    "---@field {} {} As of g.{}.\n", field.name, lua_type_of(field), kind.name);
    return text
           + "\n---The world of a running level; there is none before on_update is called.\n"
             "---@class (exact) gnomon.world\n---@field time number Seconds since the level "
             "began.\n"
             "local world = {}\n\n---What is called by a name; an error when nothing is.\n"
             "---@param name string\n---@return gnomon.handle\nfunction world:find(name) end\n\n"
             "g.world = world\n";
}

std::string live_reference(const Schema& schema) {
    std::string page =
        "\n## While a level runs\n\n"
        "`on_update(dt)` of the scene is called before each frame with the seconds since the last "
        "one. It may read "
        "`g.world.time`, the seconds since the level began, and find what has a name; what it "
        "finds can be read and, "
        "within the ranges above, set:\n\n"
        "```lua\nlocal world = g.world\nreturn g.scene {\n  on_update = function(dt)\n"
        "    local lamp = world:find(\"lamp\")\n"
        "    lamp.intensity = 900 + 100 * math.sin(9 * world.time)\n  end,\n"
        "  g.lamp { name = \"lamp\" },\n}\n```\n\n"
        "Lists are copies: `lamp.position = {0, 2, 1}` moves it, `lamp.position[1] = 0` does not. "
        "What goes along a path "
        "has its position from there. One call may use a million instructions and a second of "
        "processor time; it runs "
        "the same on every machine. A call that fails is told with its place and traceback, once, "
        "and `on_update` "
        "is not called again; the level goes on.\n\n| kind | what can be read and set "
        "|\n|---|---|\n";
    for (const Kind& kind : schema.kinds) {
        std::vector<std::string> names;
        for (const Field& field : kind.fields)
            if (field.live) names.push_back("`" + field.name + "`");
        if (!names.empty()) page += fmt::format("| {} | {} |\n", kind.name, fmt::join(names, ", "));
    }
    return page;
}

} // namespace

std::string lua_annotations(const Schema& schema) {
    std::string text =
        fmt::format("---@meta gnomon\n-- {}.\n\n---@class gnomon\nlocal g = {{}}\n", kMade);
    for (const Kind& kind : schema.kinds) {
        text += fmt::format("\n---{}\n---@class (exact) gnomon.{}\n", kind.text, kind.name);
        for (const Field& field : kind.fields)
            text += annotation_of(field);
        if (kind.name == "scene") text += "---@field [integer] table everything in the level\n";
        if (!kind.constructed) continue;
        text += fmt::format(
            "\n---{1}\n---@param fields gnomon.{0}\n---@return gnomon.{0}\nfunction g.{0}(fields) "
            "end\n",
            kind.name,
            kind.text);
    }
    text += handle_annotations(schema);
    text += "\n---A linear colour from sRGB: srgb(\"#ff8800\") or srgb(255, 136, 0).\n"
            "---@param red string|number\n---@param green? number\n---@param blue? "
            "number\n---@return number[]\n"
            "function g.srgb(red, green, blue) end\n\nreturn g\n";
    return text;
}

std::string reference_page(const Schema& schema) {
    std::string page = fmt::format(
        "<!-- {}. -->\n# Words of a level\n\n"
        "A level is a Lua file that returns one scene. Positions are metres, right-handed, y up; "
        "angles are degrees; "
        "colours are linear (`g.srgb(\"#ff8800\")` converts). Every field may be left out.\n",
        kMade);
    for (const Kind& kind : schema.kinds)
        page += reference_of(kind);
    return page + live_reference(schema);
}

} // namespace script
