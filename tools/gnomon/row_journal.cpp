#include "tools/gnomon/row_journal.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "tools/gnomon/text_files.hpp"
#include "tools/measure/row_json.hpp"

namespace gnomon {

namespace {

struct Line {
    nlohmann::json key;
    measure::Row row;
};

engine::Result<Line> parse(const std::string& text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.contains("key") || !json.contains("row"))
        return engine::Error{R"(expected {"key": ..., "row": ...})"};
    auto row = measure::row_from_json(json["row"]);
    if (!row) return row.error();
    return Line{json["key"], *std::move(row)};
}

engine::Error cannot(const char* what, const std::filesystem::path& file) {
    return {
        fmt::format("could not be {}; expected a file in a folder with room", what),
        {file.string()}};
}

} // namespace

engine::Result<RowJournal> RowJournal::open(const std::filesystem::path& file, bool fresh) {
    RowJournal journal;
    journal.file_ = file;
    std::error_code problem;
    if (fresh || !std::filesystem::exists(file, problem)) {
        if (auto made = write_text(file, ""); !made) return made.error();
        return journal;
    }
    std::ifstream stream(file, std::ios::binary);
    std::stringstream buffer;
    buffer << stream.rdbuf();
    if (!stream) {
        // An empty file reads as a failure too.
        if (std::filesystem::file_size(file, problem) == 0 && !problem) return journal;
        return cannot("read", file);
    }
    const std::string text = buffer.str();
    int number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        ++number;
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos) {
            journal.warnings_.push_back(fmt::format(
                "{}:{}: the last line is not whole, a run ended while writing it; its row is "
                "measured again",
                file.string(),
                number));
            std::filesystem::resize_file(file, begin, problem);
            if (problem) return cannot("shortened", file);
            break;
        }
        auto line = parse(text.substr(begin, end - begin));
        if (line)
            journal.rows_[line->key.dump()] = std::move(line->row);
        else
            journal.warnings_.push_back(fmt::format(
                "{}:{}: {}; the line is left out", file.string(), number, line.error().message));
        begin = end + 1;
    }
    return journal;
}

std::optional<measure::Row> RowJournal::find(const nlohmann::json& key) const {
    const auto found = rows_.find(key.dump());
    return found == rows_.end() ? std::nullopt : std::optional(found->second);
}

engine::Result<void> RowJournal::append(const nlohmann::json& key, const measure::Row& row) {
    std::ofstream stream(file_, std::ios::binary | std::ios::app);
    stream << nlohmann::json{{"key", key}, {"row", measure::to_json(row)}}.dump() << '\n';
    stream.close();
    if (!stream) return cannot("written", file_);
    rows_[key.dump()] = row;
    ++appended_;
    return {};
}

} // namespace gnomon
