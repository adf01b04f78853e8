// What a chart draws, and where.

#include "tests/tools/chart/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tools/chart/drawing.hpp"

namespace {

using chart::Across;
using chart::Up;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

std::string drawn(const chart::Findings& findings, Across across, Up up) {
    return chart::drawing(findings.charts[0], findings.series, across, up);
}

TEST(ChartDrawing, HasEveryPointOnceWithNameAndKeyboard) {
    const std::string svg = drawn(chart_test::findings(), Across::measured, Up::wrong_percent);

    EXPECT_EQ(count_of(svg, "data-point="), 9U);
    EXPECT_EQ(count_of(svg, "class=\"p "), 9U);
    EXPECT_THAT(svg, HasSubstr("aria-label=\"map@1024: 8 ms, wrong pixels, % 1\""));
    EXPECT_EQ(count_of(svg, "tabindex=\"0\" role=\"button\""), 9U);
}

TEST(ChartDrawing, LeavesOutWhoIsNotKnownOnTheAxis) {
    const std::string svg = drawn(chart_test::findings(), Across::measured, Up::eps_px);

    EXPECT_EQ(count_of(svg, "data-point="), 8U);
    EXPECT_THAT(svg, Not(HasSubstr("ogre")));
}

TEST(ChartDrawing, ShowsPeersAtTheirTimeBesidePredictions) {
    const std::string svg = drawn(chart_test::findings(), Across::predicted, Up::wrong_percent);

    EXPECT_THAT(svg, HasSubstr("aria-label=\"ogre pcf 1024: 50 ms"));
    EXPECT_THAT(svg, HasSubstr("aria-label=\"map@1024: 4 ms"));
}

TEST(ChartDrawing, HasGuttersForZeroOnlyWhereSomethingIs) {
    chart::Findings findings = chart_test::findings();

    EXPECT_EQ(
        count_of(drawn(findings, Across::measured, Up::wrong_percent), "class=\"gutter\""), 2U);

    auto& points = findings.charts[0].points;
    std::erase_if(points, [](const chart::Point& point) {
        return *point.measured_ms == 0.0 || point.errors->wrong_px == 0.0;
    });
    EXPECT_EQ(
        count_of(drawn(findings, Across::measured, Up::wrong_percent), "class=\"gutter\""), 0U);
}

TEST(ChartDrawing, TakesTimesThatNoClockTellsApartForNone) {
    chart::Findings findings = chart_test::findings();
    auto& points = findings.charts[0].points;
    points[0].measured_ms = 0.004; // noise must not stretch the axis by decades

    const std::string svg = drawn(findings, Across::measured, Up::wrong_percent);

    EXPECT_THAT(svg, HasSubstr(">&lt; 0.1</text>"));
    EXPECT_THAT(svg, Not(HasSubstr(">0.01</text>")));
    EXPECT_THAT(svg, HasSubstr("aria-label=\"none: 0 ms"));
}

TEST(ChartDrawing, HasTheFloorsOfItsTruth) {
    const chart::Findings findings = chart_test::findings();

    const auto floors = chart::floors(findings.charts[0], Up::eps_px);

    // The mean |cos| of an edge's direction is 2 / pi; shifts of 1/16 and 1/2 px.
    ASSERT_THAT(floors, SizeIs(2));
    EXPECT_NEAR(floors[0].value, 2.0 / 3.14159265 / 16.0, 1e-6);
    EXPECT_NEAR(floors[1].value, 2.0 / 3.14159265 / 2.0, 1e-6);
    EXPECT_NEAR(
        chart::floors(findings.charts[0], Up::wrong_percent)[0].value,
        floors[0].value * 500.0 / 10000.0 * 100.0,
        1e-9);
    const std::string svg = drawn(findings, Across::measured, Up::wrong_percent);
    EXPECT_THAT(svg, HasSubstr("precision floor"));
    EXPECT_THAT(svg, HasSubstr("half-pixel floor"));
}

TEST(ChartDrawing, KnowsNoFloorInWrongPixelsOfASoftLight) {
    chart::Findings findings = chart_test::findings();
    findings.charts[0].soft = true;

    EXPECT_THAT(chart::floors(findings.charts[0], Up::wrong_percent), SizeIs(0));
    EXPECT_THAT(chart::floors(findings.charts[0], Up::error_px), SizeIs(2));
}

TEST(ChartDrawing, JoinsAutoInTheOrderOfItsBudgets) {
    chart::Findings findings = chart_test::findings();
    auto& points = findings.charts[0].points;
    points.push_back(chart_test::point("auto@1", 10.0, 50.0));
    points.back().budget_px = 1.0;

    const std::string svg = drawn(findings, Across::measured, Up::wrong_percent);

    EXPECT_EQ(count_of(svg, "class=\"auto-curve\""), 1U);
    EXPECT_THAT(svg, HasSubstr(">0.1 px</text>"));
    EXPECT_THAT(svg, HasSubstr(">1 px</text>"));
    const std::size_t curve = svg.find("class=\"auto-curve\"");
    const std::string line = svg.substr(curve, svg.find("/>", curve) - curve);
    // The largest budget was named last but one here and comes last: x falls along the curve.
    const auto x_of = [&](std::size_t from) { return std::stod(line.substr(from)); };
    const std::size_t first = line.find("points=\"") + 8;
    const std::size_t second = line.find(' ', first) + 1;
    const std::size_t third = line.find(' ', second) + 1;
    EXPECT_GT(x_of(first), x_of(second));
    EXPECT_GT(x_of(second), x_of(third));
}

TEST(ChartDrawing, GivesEverySeriesAShapeOfItsOwn) {
    const chart::Series series = {
        {"none", "blob", "planar", "shadow_texture", "volume", "map", "traced", "auto"},
        {"filament", "irrlicht", "ogre", "osg", "three"}};
    std::set<std::string_view> own;
    std::set<std::string_view> peers;

    for (const std::string& name : series.own)
        own.insert(series.shape(name));
    for (const std::string& name : series.peers)
        peers.insert(series.shape(name));

    EXPECT_EQ(own.size(), series.own.size());
    EXPECT_EQ(peers.size(), series.peers.size());
    EXPECT_EQ(series.css_class("planar"), "m2");
    EXPECT_EQ(series.css_class("ogre"), "q2");
}

TEST(ChartDrawing, EscapesNames) {
    const std::string svg = drawn(chart_test::findings(), Across::measured, Up::wrong_percent);

    EXPECT_THAT(svg, HasSubstr("sun &lt;1&gt;"));
    EXPECT_THAT(svg, Not(HasSubstr("sun <1>")));
}

TEST(ChartDrawing, IsAFileOfItsOwnWithColours) {
    const std::string file =
        chart::svg_file(drawn(chart_test::findings(), Across::measured, Up::wrong_percent));

    EXPECT_THAT(file, testing::StartsWith("<svg class=\"chart\" xmlns="));
    EXPECT_THAT(file, HasSubstr("--ink: #222"));
    EXPECT_THAT(file, HasSubstr("prefers-color-scheme: dark"));
    EXPECT_THAT(file, HasSubstr(".m0 { stroke"));
    EXPECT_THAT(file, Not(HasSubstr("body {")));
    EXPECT_EQ(count_of(file, "<svg"), 1U);
}

} // namespace
