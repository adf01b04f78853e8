// The part of shader_source.hpp that works on text: includes, defines and messages.

#include "engine/gpu/shader_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace gpu {

namespace {

constexpr std::string_view kSpaces = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kSpaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// Takes the first line off `text`, without its end.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    return line;
}

/// What follows `#word` on a line which is that directive: `# word` counts too.
std::optional<std::string_view> directive(std::string_view line, std::string_view word) {
    line = trimmed(line);
    if (!line.starts_with('#')) return std::nullopt;
    line = trimmed(line.substr(1));
    if (!line.starts_with(word)) return std::nullopt;
    const std::string_view rest = line.substr(word.size());
    if (!rest.empty() && kSpaces.find(rest.front()) == std::string_view::npos && rest.front() != '"'
        && rest.front() != '<') {
        return std::nullopt;
    }
    return trimmed(rest);
}

class Expander {
public:
    Expander(std::span<const std::string> defines, const ShaderReader& read)
        : defines_(defines),
          read_(read) {}

    engine::Result<void> add_file(const std::string& name) {
        engine::Result<std::string> text = read_(name);
        if (!text) return text.error();
        result_.files.push_back(name);

        std::string_view rest = *text;
        for (int line_number = 1; !rest.empty(); ++line_number) {
            const std::string_view line = take_line(rest);
            engine::Result<void> added = add_line(line, {name, line_number});
            if (!added) return added;
        }
        return {};
    }

    [[nodiscard]] bool has_version() const { return has_version_; }
    [[nodiscard]] ExpandedShader take() { return std::move(result_); }

private:
    engine::Result<void> add_line(std::string_view line, const engine::SourcePlace& place) {
        if (directive(line, "version")) {
            if (result_.files.size() > 1) {
                return engine::Error{"#version may stand in main files only", place};
            }
            has_version_ = true;
            put(line, place);
            for (const std::string& define : defines_)
                put(define_line(define), place);
        } else if (const auto target = directive(line, "include")) {
            return include(*target, place);
        } else {
            put(directive(line, "pragma") == "once" ? "" : line, place);
        }
        return {};
    }

    engine::Result<void> include(std::string_view target, const engine::SourcePlace& place) {
        if (target.starts_with('<')) {
            put("", place);
            return {};
        }
        const std::size_t end = target.find('"', 1);
        if (!target.starts_with('"') || end == std::string_view::npos) {
            return engine::Error{"#include wants a file name in double quotes", place};
        }
        if (!has_version_) return engine::Error{"#include stands before #version", place};
        const std::string name(target.substr(1, end - 1));
        if (std::find(result_.files.begin(), result_.files.end(), name) != result_.files.end()) {
            return {};
        }
        engine::Result<void> added = add_file(name);
        if (added) return {};
        engine::Error error = added.error();
        if (error.place.file.empty()) error.place = place;
        return error;
    }

    void put(std::string_view line, const engine::SourcePlace& place) {
        result_.text.append(line).push_back('\n');
        result_.lines.push_back(place);
    }

    /// "#define NAME VALUE" of "NAME=VALUE".
    static std::string define_line(std::string_view define) {
        const std::size_t equals = define.find('=');
        const std::string_view name = define.substr(0, equals);
        if (equals == std::string_view::npos) return fmt::format("#define {}", name);
        return fmt::format("#define {} {}", name, define.substr(equals + 1));
    }

    std::span<const std::string> defines_;
    const ShaderReader& read_;
    ExpandedShader result_;
    bool has_version_ = false;
};

/// One line of a driver's log, taken apart.
struct LogLine {
    engine::SourcePlace place; ///< without a file when the line names none
    std::string text;
};

bool take_number(std::string_view& text, std::size_t& number) {
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failed != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

bool take(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

LogLine parse_log_line(std::string_view line, const ExpandedShader& shader) {
    LogLine unchanged = {{}, std::string(line)};
    std::string_view rest = line;
    const bool error_first = take(rest, "ERROR: "); // a third form: "ERROR: 0:17: text"
    std::size_t file = 0;                           // of no use: see ExpandedShader
    std::size_t number = 0;
    if (!take_number(rest, file)) return unchanged;
    if (take(rest, "(")) {
        if (!take_number(rest, number) || !take(rest, ")")) return unchanged;
    } else {
        if (!take(rest, ":") || !take_number(rest, number)) return unchanged;
        std::size_t column = 0;
        if (take(rest, "(") && (!take_number(rest, column) || !take(rest, ")"))) return unchanged;
    }
    rest = trimmed(rest);
    if (!take(rest, ":") || number == 0 || number > shader.lines.size()) return unchanged;
    return {
        shader.lines[number - 1], fmt::format("{}{}", error_first ? "error: " : "", trimmed(rest))};
}

std::string to_string(const LogLine& line) {
    if (line.place.file.empty()) return line.text;
    return fmt::format("{}:{}: {}", line.place.file, line.place.line, line.text);
}

std::vector<LogLine> parse_log(std::string_view log, const ExpandedShader& shader) {
    std::vector<LogLine> lines;
    while (!log.empty()) {
        const std::string_view line = take_line(log);
        const std::size_t end = line.find_last_not_of(std::string_view(" \t\r\0", 4));
        if (end == std::string_view::npos) continue;
        lines.push_back(parse_log_line(line.substr(0, end + 1), shader));
    }
    return lines;
}

} // namespace

engine::Result<ExpandedShader> expand_shader(
    const std::string& name, std::span<const std::string> defines, const ShaderReader& read) {
    Expander expander(defines, read);
    const engine::Result<void> added = expander.add_file(name);
    if (!added) return added.error();
    if (!expander.has_version()) return engine::Error{"this shader has no #version", {name, 1}};
    return expander.take();
}

std::string readable_log(std::string_view log, const ExpandedShader& shader) {
    std::string text;
    for (const LogLine& line : parse_log(log, shader))
        text += to_string(line) + '\n';
    return text;
}

engine::Error error_from_log(std::string_view log, const ExpandedShader& shader) {
    const std::vector<LogLine> lines = parse_log(log, shader);
    const auto is_error = [](const LogLine& line) {
        return !line.place.file.empty() && line.text.find("error") != std::string::npos;
    };
    auto first = std::find_if(lines.begin(), lines.end(), is_error);
    if (first == lines.end()) first = lines.begin();
    if (first == lines.end()) return {"the driver refused the shader without a message"};

    engine::Error error = {first->text, first->place};
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        if (line != first) error.message += '\n' + to_string(*line);
    }
    return error;
}

} // namespace gpu
