// Pages of charts as a reader uses them, in Debian's Chromium: open_chart.py stays, clicks and
// types, in a light and in a dark browser.

#include "tests/support/programs.hpp"
#include "tests/tools/chart/points.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

using test_support::Outcome;
using test_support::run;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr int kSkipped = 77;

class ChartBrowser : public test_support::TestWithFolder {
protected:
    Outcome open(const std::string& page) const {
        write("chart.html", page);
        return open();
    }
    Outcome open() const {
        return run(fmt::format("python3 '{}' '{}'", OPEN_CHART, path("chart.html")));
    }
};

TEST_F(ChartBrowser, UsesAPageOfMadeUpPoints) {
    const Outcome outcome = open(chart::chart_page(chart_test::findings()));

    if (outcome.code == kSkipped) GTEST_SKIP() << outcome.text;
    EXPECT_EQ(outcome.code, 0) << outcome.text;
}

TEST_F(ChartBrowser, UsesThePageOfASceneWithTwoLights) {
    std::ofstream(folder_ / "level.lua") << test_support::kTwoLights;
    std::ofstream(folder_ / "peers.csv") << "scene,peer,config,cost,wrong\nlevel,ogre,pcf,3,0.5\n";
    const Outcome made = run(fmt::format(
        "'{0}' chart '{1}/level.lua' --size 160x90 --frames 1 --overlay '{1}/peers.csv' "
        "--technique none,planar,map@256:pcf,map@1024:pcf,auto@0.5,auto@4 --out '{1}'",
        GNOMON_PROGRAM,
        folder_.string()));
    if (made.code == kSkipped) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(made.code, 0) << made.text;
    EXPECT_TRUE(fs::exists(folder_ / "chart_level.svg"));
    EXPECT_TRUE(fs::exists(folder_ / "chart_level_sun.svg"));
    EXPECT_TRUE(fs::exists(folder_ / "chart_level_lamp.svg"));

    const Outcome outcome = open();

    if (outcome.code == kSkipped) GTEST_SKIP() << outcome.text;
    EXPECT_EQ(outcome.code, 0) << outcome.text;
}

// The judge itself: what it should find, it finds.

std::string without(std::string page, const std::string& part) {
    const std::size_t at = page.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return page.erase(at, part.size());
}

TEST_F(ChartBrowser, TellsAPageThatDoesNotOpenItsPictures) {
    const Outcome outcome =
        open(without(chart::chart_page(chart_test::findings()), "  if (found) pin(found);\n"));

    if (outcome.code == kSkipped) GTEST_SKIP() << outcome.text;
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.text, HasSubstr("opens no panel"));
}

TEST_F(ChartBrowser, TellsAPageThatAsksForAFile) {
    const Outcome outcome = open(
        chart::chart_page(chart_test::findings()) + "<img src=\"https://example.invalid/a.png\">");

    if (outcome.code == kSkipped) GTEST_SKIP() << outcome.text;
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.text, HasSubstr("example.invalid"));
}

TEST_F(ChartBrowser, TellsAPageThatCannotBeReadInTheDark) {
    std::string page = chart::chart_page(chart_test::findings());
    const std::string paper = "--paper: #16181c";
    page.replace(page.find(paper), paper.size(), "--paper: #8899aa");

    const Outcome outcome = open(page);

    if (outcome.code == kSkipped) GTEST_SKIP() << outcome.text;
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.text, HasSubstr("dark"));
}

} // namespace
