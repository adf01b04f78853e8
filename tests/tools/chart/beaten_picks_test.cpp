// Picks that are not worth their cost are named, with what beats them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/chart/beaten_picks.hpp"

namespace {

using chart::Across;
using chart::Up;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

chart::Point point(const std::string& name, double ms, double wrong_percent) {
    chart::Point point;
    point.name = name;
    point.predicted_ms = ms;
    point.wrong_percent = wrong_percent;
    return point;
}

chart::Point pick(const std::string& name, double ms, double wrong_percent) {
    chart::Point made = point(name, ms, wrong_percent);
    made.budget_px = 1.0;
    return made;
}

std::vector<std::string> beaten(std::vector<chart::Point> points) {
    chart::Chart chart;
    chart.scene = "court";
    chart.points = std::move(points);
    return chart::beaten_picks(chart, Across::predicted, Up::wrong_percent);
}

TEST(BeatenPicks, AreNoneWhenAllLieOnTheFront) {
    EXPECT_THAT(
        beaten({point("volume", 3.0, 0.0), point("blob", 1.0, 2.0), pick("auto@1", 1.0, 2.0)}),
        IsEmpty());
}

TEST(BeatenPicks, AreNamedWithWhatBeatsThem) {
    EXPECT_THAT(
        beaten({point("volume", 3.0, 0.0), pick("auto@1", 4.0, 0.5)}),
        ElementsAre(AllOf(HasSubstr("auto@1"), HasSubstr("is beaten by volume"))));
}

TEST(BeatenPicks, CannotHideByMissingAValue) {
    chart::Point nowhere = pick("auto@1", 1.0, 1.0);
    nowhere.predicted_ms = std::nullopt;

    EXPECT_THAT(beaten({nowhere}), ElementsAre(HasSubstr("auto@1 has no place")));
}

TEST(BeatenPicks, AreNotHeldAgainstTheTruth) {
    chart::Point truth = point("traced", 0.1, 0.0);
    truth.is_truth = true;

    EXPECT_THAT(beaten({truth, pick("auto@1", 1.0, 2.0)}), IsEmpty());
}

} // namespace
