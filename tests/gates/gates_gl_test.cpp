// Every technique keeps what it promises on the committed scenes. Keeps a table of the figures as
// gates.md, and the renderer's name, in the folder of GNOMON_RESULTS, where that is set.

#include "tests/gates/results_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tools/gnomon/studio.hpp"

namespace gates {
namespace {

MarkdownTable empty_table() {
    std::vector<std::string> titles = {"scene", "technique"};
    for (const ShownFigure& shown : shown_figures())
        titles.push_back(shown.title);
    return MarkdownTable(titles);
}

class Gates : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() { table_.emplace(empty_table()); }
    static void TearDownTestSuite() {
        for (const auto& [name, text] :
             {std::pair<std::string, std::string>("gates", table_->text()),
              {"renderer", renderer_}}) {
            const auto kept = keep_result(name, text);
            EXPECT_TRUE(kept) << engine::to_string(kept.error());
        }
    }
    void SetUp() override {
        if (!gnomon::Studio::open(16, 16)) GTEST_SKIP() << "no OpenGL here";
    }

    /// Each figure with its limit.
    static void add_to_table(const Promise& promised, std::span<const measure::Row> rows) {
        std::vector<std::string> cells = {promised.scene, fmt::format("`{}`", promised.technique)};
        for (const ShownFigure& shown : shown_figures()) {
            const auto limit = loosest(promised, shown.figure);
            const std::string value = cell(worst(promised, rows, shown.figure));
            cells.push_back(limit ? fmt::format("{} ({})", value, cell(limit)) : value);
        }
        table_->add(cells);
        renderer_ = rows.front().renderer;
    }

    static std::optional<MarkdownTable> table_;
    static std::string renderer_;
};

std::optional<MarkdownTable> Gates::table_;
std::string Gates::renderer_;

TEST_P(Gates, HoldOnTheScene) {
    std::vector<Promise> promised;
    for (const Promise& one : promises())
        if (one.scene == GetParam()) promised.push_back(one);
    const auto rows = measure_promises(promised);
    ASSERT_TRUE(rows) << engine::to_string(rows.error());

    for (const Promise& one : promised) {
        add_to_table(one, *rows);
        for (const Broken& broken : broken_gates(one, *rows))
            ADD_FAILURE() << broken.sentence;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Gates, testing::ValuesIn(scenes()), [](const testing::TestParamInfo<std::string>& one) {
        return one.param;
    });

} // namespace
} // namespace gates
