// Charts for other programs.

#include "tests/tools/chart/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/chart/overlay.hpp"
#include "tools/chart/tables.hpp"

namespace {

using testing::ElementsAre;

TEST(ChartTables, HaveARowAPoint) {
    const auto rows = chart::csv_rows(chart::csv(chart_test::findings().charts));

    ASSERT_EQ(rows.size(), 10U);
    EXPECT_THAT(
        rows[3],
        ElementsAre(
            "made_up", "sun <1>", "map@1024", "map", "0", "8", "4", "1", "0.2", "100", "", "1"));
    EXPECT_THAT(
        rows[9],
        ElementsAre(
            "made_up", "sun <1>", "ogre pcf 1024", "ogre", "1", "50", "", "3", "", "", "", "1"));
}

TEST(ChartTables, SayTheSameInJsonAndWhatHasNoPoint) {
    const auto json = nlohmann::json::parse(chart::json(chart_test::findings().charts));

    const auto& one = json["charts"][0];
    EXPECT_EQ(one["light"], "sun <1>");
    EXPECT_EQ(one["points"].size(), 9U);
    EXPECT_EQ(one["points"][6]["budget_px"], 0.1);
    EXPECT_EQ(one["points"][6]["front"], false);
    EXPECT_TRUE(one["points"][8]["eps_px"].is_null());
    EXPECT_EQ(one["refusals"][0]["name"], "planar");
    EXPECT_NEAR(one["floors"]["eps_px"]["half-pixel floor"].get<double>(), 0.3183, 1e-4);
}

TEST(ChartErrors, OfSeveralLightsAddUp) {
    chart::Point both = chart_test::point("map", 1.0, 100.0);
    *both.errors += *chart_test::point("map", 1.0, 300.0).errors;

    EXPECT_DOUBLE_EQ(*value(both, chart::Up::wrong_percent), 2.0); // 400 of 20000
    EXPECT_DOUBLE_EQ(*value(both, chart::Up::eps_px), 0.4);        // 400 over 1000
    EXPECT_DOUBLE_EQ(*value(both, chart::Up::error_px), 400.0);
}

TEST(ChartErrors, WithoutAnEdgeHaveNoEps) {
    chart::Point point = chart_test::point("map", 1.0, 100.0);
    point.errors->edge_px = 0.0;

    EXPECT_FALSE(value(point, chart::Up::eps_px));
}

} // namespace
