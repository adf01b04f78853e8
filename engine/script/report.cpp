#include "engine/script/report.hpp"

#include "engine/script/source_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace script {

namespace {

constexpr std::size_t kMaxMessages = 100;

std::vector<engine::Error> sorted(std::vector<engine::Error> errors) {
    std::stable_sort(errors.begin(), errors.end(), [](const auto& left, const auto& right) {
        return std::tie(left.place.file, left.place.line)
               < std::tie(right.place.file, right.place.line);
    });
    return errors;
}

} // namespace

Subject Subject::inside(const std::string& field) const {
    Subject nested = *this;
    nested.path.push_back(field);
    return nested;
}

engine::Error Report::placed(
    const Subject& subject, const std::string& field, const std::string& complaint) const {
    std::vector<std::string> path = subject.path;
    if (!field.empty()) path.push_back(field);
    engine::SourcePlace place = subject.place;
    if (const auto source = sources_.find(place.file); source != sources_.end())
        place.line = field_line(source->second, place.line, subject.constructor, path);
    const std::string separator = path.empty() ? "" : " ";
    return {
        fmt::format("{}: {}{}{}", subject.title, fmt::join(path, "."), separator, complaint),
        place};
}

void Report::error(const Subject& subject, const std::string& field, const std::string& complaint) {
    if (errors_.size() + 1 >= kMaxMessages) {
        ++more_errors_;
    } else {
        errors_.push_back(placed(subject, field, complaint));
    }
}

void Report::error(engine::Error error) {
    errors_.push_back(std::move(error));
}

void Report::warn(const Subject& subject, const std::string& field, const std::string& complaint) {
    if (warnings_.size() < kMaxMessages) warnings_.push_back(placed(subject, field, complaint));
}

std::vector<engine::Error> Report::errors() const {
    std::vector<engine::Error> errors = sorted(errors_);
    if (more_errors_ > 0)
        errors.push_back(
            {fmt::format("and {} more mistakes", more_errors_), {errors.front().place.file, 0}});
    return errors;
}

std::vector<std::string> Report::warnings() const {
    std::vector<std::string> lines;
    for (const engine::Error& warning : sorted(warnings_))
        lines.push_back(engine::to_string(warning));
    return lines;
}

} // namespace script
