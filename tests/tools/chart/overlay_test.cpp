// Points of other engines, read from tables.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/chart/overlay.hpp"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr const char* kTable = "scene,peer,config,map,cost,wrong,load,failed,note\r\n"
                               "plaza,ogre,pcf,1024,19.25,1.9135,0.5,,\r\n"
                               "plaza,ogre,stencil,0,71,0.0035,0.5,,\"quick, \"\"dirty\"\"\"\n"
                               "room,irrlicht,zfail,0,12,0.2,0.5,,\n"
                               "room,filament,vsm,1024,,,,unsupported,no point lights\n";

TEST(Csv, KeepsCommasQuotesAndLinesInsideQuotes) {
    EXPECT_THAT(
        chart::csv_rows("a,\"b,\"\"c\"\"\nd\"\r\n,\r\n"),
        ElementsAre(ElementsAre("a", "b,\"c\"\nd"), ElementsAre("", "")));
}

TEST(Overlay, HoldsEachScenesPointsWithTheirFacts) {
    const auto overlay = chart::read_overlay(kTable, "results.csv");

    ASSERT_TRUE(overlay) << to_string(overlay.error());
    EXPECT_THAT(overlay->peers, ElementsAre("irrlicht", "ogre"));
    const auto& plaza = overlay->by_scene.at("plaza");
    ASSERT_EQ(plaza.size(), 2U);
    EXPECT_EQ(plaza[0].name, "ogre pcf 1024");
    EXPECT_EQ(plaza[0].series, "ogre");
    EXPECT_EQ(plaza[0].measured_ms, 19.25);
    EXPECT_EQ(plaza[0].wrong_percent, 1.9135);
    EXPECT_EQ(plaza[1].name, "ogre stencil");
    EXPECT_THAT(plaza[1].facts, ElementsAre(Pair("load", "0.5"), Pair("note", "quick, \"dirty\"")));
}

TEST(Overlay, LeavesOutWhatFailed) {
    const auto overlay = chart::read_overlay(kTable, "results.csv");

    ASSERT_TRUE(overlay);
    EXPECT_EQ(overlay->by_scene.at("room").size(), 1U);
}

TEST(Overlay, IsKnownInWrongPixelsAlone) {
    const auto overlay = chart::read_overlay(kTable, "results.csv");

    ASSERT_TRUE(overlay);
    const chart::Point& point = overlay->by_scene.at("plaza")[0];
    EXPECT_TRUE(value(point, chart::Up::wrong_percent));
    EXPECT_FALSE(value(point, chart::Up::eps_px));
    EXPECT_FALSE(value(point, chart::Up::error_px));
}

TEST(Overlay, IsAlsoReadFromJson) {
    const auto overlay = chart::read_overlay(
        R"([{"scene": "a", "peer": "x", "config": "pcf", "map": 512, "cost": 3.5, "wrong": 0.25}])",
        "x.json");

    ASSERT_TRUE(overlay) << to_string(overlay.error());
    const chart::Point& point = overlay->by_scene.at("a")[0];
    EXPECT_EQ(point.name, "x pcf 512");
    EXPECT_EQ(point.measured_ms, 3.5);
    EXPECT_EQ(point.wrong_percent, 0.25);
}

TEST(Overlay, NamesTheColumnThatIsMissing) {
    const auto overlay = chart::read_overlay("scene,peer,config,ms\na,b,c,1\n", "x.csv");

    ASSERT_FALSE(overlay);
    EXPECT_THAT(overlay.error().message, HasSubstr("column 'cost' is missing"));
    EXPECT_THAT(overlay.error().message, HasSubstr("found scene, peer, config, ms"));
    EXPECT_EQ(overlay.error().place.file, "x.csv");
}

TEST(Overlay, NamesTheRowWithoutANumber) {
    const auto overlay =
        chart::read_overlay("scene,peer,config,cost,wrong\na,b,c,1,2\na,b,c,1,much\n", "x.csv");

    ASSERT_FALSE(overlay);
    EXPECT_THAT(overlay.error().message, HasSubstr("row 3"));
    EXPECT_THAT(overlay.error().message, HasSubstr("'much'"));
}

TEST(Overlay, RefusesWhatIsNoTable) {
    EXPECT_FALSE(chart::read_overlay("", "x.csv"));
    EXPECT_FALSE(chart::read_overlay("scene,peer,config,cost,wrong\n", "x.csv"));
    EXPECT_FALSE(chart::read_overlay("a,b\n1\n", "x.csv"));
    EXPECT_FALSE(chart::read_overlay("{}", "x.json"));
    EXPECT_FALSE(chart::read_overlay("[1]", "x.json"));
    EXPECT_FALSE(chart::read_overlay("no json", "x.json"));
}

} // namespace
