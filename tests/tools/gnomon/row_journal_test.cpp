#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "tools/gnomon/row_journal.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Journal : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path()
                  / ("gnomon_journal_" + std::to_string(getpid()) + "_"
                     + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] fs::path file() const { return folder_ / "rows.jsonl"; }
    [[nodiscard]] std::string text() const {
        std::stringstream buffer;
        buffer << std::ifstream(file()).rdbuf();
        return buffer.str();
    }
    [[nodiscard]] RowJournal open(bool fresh = false) const {
        auto journal = RowJournal::open(file(), fresh);
        EXPECT_TRUE(journal);
        return *std::move(journal);
    }

    static measure::Row row(const std::string& technique, double error_px) {
        measure::Row row;
        row.technique = technique;
        row.figures.emplace().error_px = error_px;
        return row;
    }

    fs::path folder_;
};

const nlohmann::json kMap = {{"technique", "map"}};
const nlohmann::json kVolume = {{"technique", "volume"}};

TEST_F(Journal, KeepsRowsFromRunToRun) {
    ASSERT_TRUE(open().append(kMap, row("map", 0.1)));
    RowJournal second = open();
    ASSERT_TRUE(second.append(kVolume, row("volume", 0.2)));

    const RowJournal third = open();

    ASSERT_TRUE(third.find(kMap));
    EXPECT_EQ(third.find(kMap)->figures->error_px, 0.1);
    ASSERT_TRUE(third.find(kVolume));
    EXPECT_EQ(third.find(kVolume)->technique, "volume");
    EXPECT_FALSE(third.find({{"technique", "map"}, {"frames", 3}}));
    EXPECT_THAT(third.warnings(), ElementsAre());
    EXPECT_EQ(second.appended(), 1U);
}

TEST_F(Journal, TakesTheLatestRowOfAKey) {
    RowJournal journal = open();
    ASSERT_TRUE(journal.append(kMap, row("map", 0.1)));
    ASSERT_TRUE(journal.append(kMap, row("map", 0.3)));

    EXPECT_EQ(open().find(kMap)->figures->error_px, 0.3);
}

TEST_F(Journal, ForgetsEverythingWhenAskedTo) {
    ASSERT_TRUE(open().append(kMap, row("map", 0.1)));

    EXPECT_FALSE(open(true).find(kMap));
    EXPECT_EQ(text(), "");
}

TEST_F(Journal, ALineThatWasCutIsTakenOffAndTheRestKept) {
    RowJournal journal = open();
    ASSERT_TRUE(journal.append(kMap, row("map", 0.1)));
    const std::string whole = text();
    ASSERT_TRUE(journal.append(kVolume, row("volume", 0.2)));
    const std::string both = text();
    for (const std::size_t length : {whole.size() + 1, whole.size() + 40, both.size() - 1}) {
        SCOPED_TRACE(length);
        std::ofstream(file(), std::ios::trunc) << both.substr(0, length);

        RowJournal again = open();

        EXPECT_TRUE(again.find(kMap));
        EXPECT_FALSE(again.find(kVolume));
        EXPECT_THAT(again.warnings(), ElementsAre(HasSubstr(":2: the last line is not whole")));
        EXPECT_EQ(text(), whole);
        ASSERT_TRUE(again.append(kVolume, row("volume", 0.2)));
        EXPECT_EQ(text(), both);
    }
}

TEST_F(Journal, ADamagedLineInTheMiddleIsLeftOutWithAWarning) {
    ASSERT_TRUE(open().append(kMap, row("map", 0.1)));
    const std::string good = text();
    std::ofstream(file(), std::ios::trunc) << "{\"key\": 1, \"row\": {\"scene\": 3}}\nnonsense\n"
                                           << good;

    const RowJournal journal = open();

    EXPECT_TRUE(journal.find(kMap));
    EXPECT_THAT(
        journal.warnings(),
        ElementsAre(HasSubstr(":1: a row without 'scene'"), HasSubstr(":2: expected")));
}

TEST_F(Journal, SaysWhenItCannotBeMade) {
    const auto journal = RowJournal::open(folder_ / "nowhere" / "rows.jsonl", false);

    ASSERT_FALSE(journal);
    EXPECT_THAT(engine::to_string(journal.error()), HasSubstr("rows.jsonl"));
}

} // namespace
} // namespace gnomon
