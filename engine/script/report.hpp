// The mistakes of a level, all of them, each with the line where it was written.

#pragma once

#include "engine/core/result.hpp"

#include <map>
#include <string>
#include <vector>

namespace script {

/// A table of a level, as messages speak of it.
struct Subject {
    std::string title;             ///< sun "sun"
    std::string constructor;       ///< the word that made it: where to look for its fields
    engine::SourcePlace place;     ///< of the constructor
    std::vector<std::string> path; ///< fields that lead from there to the table; empty for itself

    [[nodiscard]] Subject inside(const std::string& field) const;
};

class Report {
public:
    /// @param sources texts by file name; they must outlive the report
    explicit Report(const std::map<std::string, std::string>& sources) : sources_(sources) {}

    /// "levels/yard.lua:5: sun "sun": shadow.cascades is ..."; an empty field means the table
    /// itself.
    void error(const Subject& subject, const std::string& field, const std::string& complaint);
    void error(engine::Error error);
    void warn(const Subject& subject, const std::string& field, const std::string& complaint);

    /// Sorted by file and line; at most 100, the last of which then counts the others.
    [[nodiscard]] std::vector<engine::Error> errors() const;
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    [[nodiscard]] engine::Error
    placed(const Subject& subject, const std::string& field, const std::string& complaint) const;

    const std::map<std::string, std::string>& sources_;
    std::vector<engine::Error> errors_;
    std::vector<engine::Error> warnings_;
    std::size_t more_errors_ = 0;
};

} // namespace script
