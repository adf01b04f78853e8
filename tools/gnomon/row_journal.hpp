// Rows on disk as soon as they are finished, so that a run that was interrupted goes on where it
// stopped.
//
// One line a row, only ever appended: {"key": ..., "row": ...}. The key is everything that the row
// depends on (row_key.hpp), so a row is found again exactly when measuring it would give it again.

#pragma once

#include "engine/core/result.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/measure/report.hpp"

namespace gnomon {

class RowJournal {
public:
    /// Reads the rows of earlier runs; without a file there are none.
    /// @param fresh forget them
    /// Errors: the file cannot be read or made. A line that is damaged is left out, with a warning;
    /// the last one, where a run was ended in the middle of it, is also taken off the file.
    static engine::Result<RowJournal> open(const std::filesystem::path& file, bool fresh);

    /// The latest row with this key.
    [[nodiscard]] std::optional<measure::Row> find(const nlohmann::json& key) const;
    /// Errors: the disk is full.
    engine::Result<void> append(const nlohmann::json& key, const measure::Row& row);

    /// Rows that append() took.
    [[nodiscard]] std::size_t appended() const { return appended_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// One sentence for each damaged line.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::filesystem::path file_;
    std::map<std::string, measure::Row> rows_; ///< by key
    std::vector<std::string> warnings_;
    std::size_t appended_ = 0;
};

} // namespace gnomon
