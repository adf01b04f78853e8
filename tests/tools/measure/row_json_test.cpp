#include "engine/core/random.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "tools/measure/row_json.hpp"

namespace measure {
namespace {

/// Any number that is one: of any size, with all its bits.
double any_number(engine::Random& random) {
    const double value =
        std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(80)) - 40);
    return random.below(8) == 0 ? 0.0 : value;
}

std::string any_text(engine::Random& random) {
    static const std::vector<std::string> kTexts = {
        "", "sun", "a \"quoted\" one", "two\nlines", "map@1024:pcf", "h\xc3\xa9ros", "back\\slash"};
    return kTexts[random.below(static_cast<std::uint32_t>(kTexts.size()))];
}

template <class T>
void fill(std::optional<T>& group, engine::Random& random) {
    if (random.below(4) == 0) return;
    group.emplace();
    for (const FigureColumn<T>& column : columns_of<T>()) {
        if (column.access.set == nullptr) continue;
        const bool may_be_missing = !column.access.get(T{}).known();
        if (may_be_missing && random.below(3) == 0)
            column.access.set(*group, Figure::missing(any_text(random)));
        else
            column.access.set(*group, any_number(random));
    }
}

Row any_row(engine::Random& random) {
    Row row;
    for (std::string Row::*text :
         {&Row::scene,
          &Row::camera,
          &Row::light,
          &Row::technique,
          &Row::picked,
          &Row::protocol,
          &Row::settings,
          &Row::renderer,
          &Row::note})
        row.*text = any_text(random);
    fill(row.figures, random);
    fill(row.motion, random);
    fill(row.timing, random);
    fill(row.counters, random);
    return row;
}

std::string everything(const Row& row) {
    Report report;
    report.add(row);
    return report.json().dump() + report.csv() + report.table();
}

TEST(RowJson, GivesTheSameRowBack) {
    engine::Random random(7);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const Row row = any_row(random);
        const nlohmann::json json = nlohmann::json::parse(to_json(row).dump());

        const auto again = row_from_json(json);

        ASSERT_TRUE(again) << again.error().message;
        EXPECT_EQ(everything(*again), everything(row));
        EXPECT_EQ(again->figures.has_value(), row.figures.has_value());
        EXPECT_EQ(to_json(*again), to_json(row));
    }
}

TEST(RowJson, SaysWhatARowLacks) {
    engine::Random random(7);
    Row row = any_row(random);
    row.figures.emplace();
    const nlohmann::json whole = to_json(row);
    ASSERT_TRUE(row_from_json(whole));
    nlohmann::json without_scene = whole;
    without_scene.erase("scene");
    nlohmann::json without_figure = whole;
    without_figure["figures"].erase("eps_px");
    nlohmann::json with_text = whole;
    with_text["figures"]["error_px"] = "no";

    EXPECT_THAT(row_from_json(without_scene).error().message, testing::HasSubstr("'scene'"));
    EXPECT_THAT(
        row_from_json(without_figure).error().message, testing::HasSubstr("'figures.eps_px'"));
    EXPECT_THAT(row_from_json(with_text).error().message, testing::HasSubstr("'figures.error_px'"));
    EXPECT_FALSE(row_from_json(nlohmann::json(3)));
    EXPECT_FALSE(row_from_json(nlohmann::json::array()));
}

} // namespace
} // namespace measure
