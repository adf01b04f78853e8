// atlas [CASES...]: runs the sweeps of the atlas, off and on, prints what they show and leaves a
// page, a table for the manual, CSV and JSON.

#include "engine/core/text.hpp"
#include "tests/atlas/cases.hpp"
#include "tests/atlas/report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "tools/gnomon/exit_codes.hpp"
#include "tools/gnomon/text_files.hpp"

namespace {

/// A word names a case ("M1"), in all techniques ("V16"), or, of letters alone, all of its kind
/// ("M").
bool names(const std::string& word, const std::string& id) {
    if (word == id || id.starts_with(word + "_")) return true;
    const auto digit = [](unsigned char letter) { return std::isdigit(letter) != 0; };
    return id.starts_with(word) && digit(static_cast<unsigned char>(id[word.size()]))
           && std::none_of(word.begin(), word.end(), digit);
}

bool wanted(const std::vector<std::string>& words, const std::string& id) {
    return words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
               return names(word, id);
           });
}

/// The first word that names nothing, as a sentence; empty when all do.
std::string unknown(const std::vector<std::string>& words, const std::vector<std::string>& ids) {
    for (const std::string& word : words)
        if (std::none_of(ids.begin(), ids.end(), [&](const auto& id) { return names(word, id); })) {
            const std::vector<std::string_view> known(ids.begin(), ids.end());
            return fmt::format("no case '{}'{}", word, engine::did_you_mean(word, known));
        }
    return {};
}

/// Tells on standard error how far the run is and how long it may still take.
class Progress {
public:
    Progress(std::size_t cases, int steps) : total_(cases * static_cast<std::size_t>(steps)) {}

    void begin(const std::string& id) { id_ = id; }
    void step() {
        ++done_;
        const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
        const double left =
            spent / static_cast<double>(done_) * static_cast<double>(total_ - done_);
        fmt::print(
            stderr,
            "\r{} of {} steps, {:<10} about {:.0f} min {:02.0f} s left ",
            done_,
            total_,
            id_ + ",",
            std::floor(left / 60.0),
            std::floor(std::fmod(left, 60.0)));
    }

private:
    using Clock = std::chrono::steady_clock;
    std::string id_;
    std::size_t done_ = 0;
    std::size_t total_;
    Clock::time_point start_ = Clock::now();
};

engine::Result<void> write_all(const std::filesystem::path& folder, const atlas::Findings& found) {
    if (auto made = gnomon::make_folder(folder); !made) return made;
    for (const auto& [name, text] : std::initializer_list<std::pair<const char*, std::string>>{
             {"atlas.html", atlas::html_page(found)},
             {"atlas.md", atlas::markdown_table(found)},
             {"atlas.csv", atlas::csv(found)},
             {"atlas.json", atlas::json(found)}})
        if (auto written = gnomon::write_text(folder / name, text); !written) return written;
    fmt::print("{}\n", (folder / "atlas.html").string());
    return {};
}

int run(const std::vector<std::string>& words, int steps, const std::filesystem::path& folder) {
    auto cases = atlas::all_cases();
    atlas::Findings found{{}, atlas::refusals(), atlas::impossible()};
    std::vector<std::string> ids;
    for (const atlas::Case& one : cases)
        ids.push_back(one.id);
    if (const std::string problem = unknown(words, ids); !problem.empty()) {
        fmt::print(stderr, "atlas: {}\n", problem);
        return gnomon::kWrongUsage;
    }
    std::erase_if(cases, [&](const atlas::Case& one) { return !wanted(words, one.id); });
    std::erase_if(found.refusals, [&](const auto& one) { return !wanted(words, one.id); });
    std::erase_if(found.impossible, [&](const auto& one) { return !wanted(words, one.id); });
    Progress progress(cases.size(), steps);
    for (const atlas::Case& one : cases) {
        progress.begin(one.id);
        found.outcomes.push_back(atlas::run_sweep(one, steps, [&] { progress.step(); }));
    }
    fmt::print(stderr, "\n");
    fmt::print("{}", atlas::text_table(found));
    if (auto written = write_all(folder, found); !written) {
        fmt::print(stderr, "atlas: {}\n", engine::to_string(written.error()));
        return gnomon::kCheckFailed;
    }
    const bool good = std::all_of(
        found.outcomes.begin(), found.outcomes.end(), [](const auto& one) { return one.good(); });
    return good ? gnomon::kFine : gnomon::kCheckFailed;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Sweeps the cases of the atlas of failures, with their remedies off and on"};
    app.name("atlas");
    std::vector<std::string> words;
    int steps = 41;
    std::string folder = "out/atlas";
    app.add_option("cases", words, "ids (M1), or what ids begin with (M); all when none is named");
    app.add_option("--steps", steps, "of each sweep")
        ->check(CLI::Range(2, 1001))
        ->capture_default_str();
    app.add_option("--out", folder, "where the page and the tables go")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? gnomon::kFine : gnomon::kWrongUsage;
    }
    return run(words, steps, folder);
}
