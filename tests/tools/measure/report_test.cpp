#include "tests/support/pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tools/measure/report.hpp"

namespace measure {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

Row measured_row(const std::string& technique) {
    const Mask truth = pictures::draw(64, 64, pictures::StraightEdge{pictures::unit(0.3), 40.0});
    const Mask measured = pictures::draw(64, 64, pictures::StraightEdge{pictures::unit(0.3), 41.0});
    Row row;
    row.scene = "yard.lua";
    row.camera = "gate";
    row.light = "sun";
    row.technique = technique;
    row.settings = "--map-size 512, --filter \"pcf\"";
    row.renderer = "llvmpipe";
    row.figures = compare(comparison(measured, truth));
    row.timing = Timing{10.0, 12.0, 7.5};
    row.counters = Counters{3, 1200, 262144, 900, 0, 8100, 1048576};
    return row;
}

Row refused_row() {
    Row row;
    row.scene = "yard.lua";
    row.light = "sun";
    row.technique = "spot_map";
    row.note = "a directional light has no cone";
    return row;
}

Report two_rows() {
    Report report;
    report.add(measured_row("cascaded_map"));
    report.add(refused_row());
    return report;
}

TEST(Report, HasNoColumnTwice) {
    std::set<std::string> names;
    for (const Column& column : two_rows().columns()) {
        EXPECT_TRUE(names.insert(std::string(column.name)).second) << column.name;
        EXPECT_FALSE(column.text.empty()) << column.name;
        EXPECT_EQ(column.cells.size(), 2U) << column.name;
    }
}

TEST(Report, WritesTheSameNumberOfFieldsInEveryLineOfCsv) {
    const std::vector<std::string> lines = lines_of(two_rows().csv());

    ASSERT_EQ(lines.size(), 3U);
    EXPECT_THAT(
        lines[0],
        testing::StartsWith(
            "scene,camera,light,technique,settings,renderer,note,picked,protocol,valid_px,"));
    const auto commas = [](const std::string& line) {
        return std::count(line.begin(), line.end(), ',');
    };
    EXPECT_EQ(commas(lines[1]), commas(lines[0]) + 1); // one inside the quoted settings
    EXPECT_EQ(commas(lines[2]), commas(lines[0]));
}

TEST(Report, QuotesCsvFieldsThatNeedIt) {
    EXPECT_THAT(two_rows().csv(), HasSubstr(R"("--map-size 512, --filter ""pcf""")"));
}

TEST(Report, WritesFiguresAndReasonsToJson) {
    const nlohmann::json json = two_rows().json();

    const nlohmann::json& measured = json["rows"][0];
    EXPECT_EQ(measured["technique"], "cascaded_map");
    EXPECT_EQ(measured["shadow_ms"], 2.5);
    EXPECT_EQ(measured["map_texels"], 262144.0);
    EXPECT_TRUE(measured["flicker_per_px"].is_null());
    EXPECT_EQ(measured["missing"]["flicker_per_px"], "not measured");
    const nlohmann::json& refused = json["rows"][1];
    EXPECT_TRUE(refused["eps_px"].is_null());
    EXPECT_EQ(refused["missing"]["eps_px"], "a directional light has no cone");
    EXPECT_EQ(json["columns"].size(), two_rows().columns().size());
}

TEST(Report, AlignsTheTableUnderNamesAndUnits) {
    const std::vector<std::string> lines = lines_of(two_rows().table());
    const auto line_with = [&](const std::string& word) {
        return std::find_if(lines.begin(), lines.end(), [&](const std::string& line) {
            return line.find(word) != std::string::npos;
        });
    };
    const auto technique = line_with("technique");
    const auto measured = line_with("cascaded_map");
    ASSERT_NE(technique, lines.end());
    ASSERT_NE(measured, lines.end());

    EXPECT_EQ(measured->find("cascaded_map"), technique->find("technique"));
    EXPECT_EQ((measured + 1)->find("spot_map"), technique->find("technique"));
    // The last column is shadow_ms: name, unit and value end together.
    EXPECT_THAT(*technique, testing::EndsWith(" shadow"));
    EXPECT_THAT(*(measured - 1), testing::EndsWith("     ms"));
    EXPECT_THAT(*measured, testing::EndsWith("   2.50"));
    EXPECT_EQ(measured->size(), technique->size());
}

TEST(Report, TellsBelowTheTableWhyAFigureIsMissing) {
    const std::string table = two_rows().table();

    EXPECT_THAT(table, HasSubstr("\n-a  "));
    EXPECT_THAT(table, HasSubstr("-b  "));
    EXPECT_THAT(table, HasSubstr("  a directional light has no cone\n"));
}

TEST(Report, RepeatsDoubtsBelowTheTable) {
    Report report;
    Row row = measured_row("volume");
    const Mask truth = pictures::draw(64, 64, pictures::StraightEdge{pictures::unit(0.3), 40.0});
    row.figures = compare(comparison(truth, truth));
    report.add(row);

    EXPECT_THAT(report.table(), HasSubstr("!  yard.lua, sun, volume: below the precision floor"));
    EXPECT_THAT(
        report.json()["rows"][0]["warnings"][0].get<std::string>(), HasSubstr("copied truth?"));
    EXPECT_THAT(two_rows().table(), Not(HasSubstr("!")));
}

TEST(Report, IsATableOfHeadersWhenEmpty) {
    EXPECT_EQ(
        lines_of(Report().table()).size(),
        5U); // words of false_shadow_in_px, over_half_pixel_floor
    EXPECT_EQ(lines_of(Report().csv()).size(), 1U);
    EXPECT_TRUE(Report().json()["rows"].empty());
}

TEST(ToJson, KeepsEveryFigureOfAStill) {
    const nlohmann::json json = to_json(*measured_row("volume").figures);

    EXPECT_EQ(json["valid_px"], 4096.0);
    EXPECT_GT(json["eps_px"].get<double>(), 0.5);
    EXPECT_THAT(json["missing"]["double_dark_px"].get<std::string>(), HasSubstr("shaded"));
    EXPECT_EQ(to_json(MotionFigures())["missing"]["pop"], "not measured");
}

} // namespace
} // namespace measure
