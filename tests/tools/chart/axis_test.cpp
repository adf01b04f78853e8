// Where values lie on a logarithmic axis, and where names find room.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/chart/labels.hpp"
#include "tools/chart/log_axis.hpp"

namespace {

using chart::LogAxis;
using testing::ElementsAre;

std::vector<std::string> labels_of(const LogAxis& axis) {
    std::vector<std::string> labels;
    for (const chart::Tick& tick : axis.ticks())
        labels.push_back(tick.label);
    return labels;
}

TEST(LogAxis, BeginsAndEndsAtRoundValues) {
    const LogAxis axis(std::vector{0.3, 47.0}, 0.0, 100.0, 10.0);

    EXPECT_DOUBLE_EQ(axis.lowest(), 0.2);
    EXPECT_DOUBLE_EQ(axis.highest(), 50.0);
    EXPECT_FALSE(axis.knows_zero());
}

TEST(LogAxis, KeepsValuesThatAreRoundAlready) {
    const LogAxis axis(std::vector{0.001, 1000.0}, 0.0, 60.0, 10.0);

    EXPECT_DOUBLE_EQ(axis.lowest(), 0.001);
    EXPECT_DOUBLE_EQ(axis.highest(), 1000.0);
    EXPECT_NEAR(axis.place(1.0), 30.0, 1e-9);
    EXPECT_NEAR(axis.place(100.0), 50.0, 1e-9);
}

TEST(LogAxis, HasAGutterForZeroAndBelowOnlyWhereThereIsSuch) {
    const LogAxis axis(std::vector{1.0, 100.0, 0.0}, 0.0, 110.0, 10.0);

    ASSERT_TRUE(axis.knows_zero());
    EXPECT_DOUBLE_EQ(axis.start(), 10.0);
    EXPECT_DOUBLE_EQ(axis.place(0.0), 5.0);
    EXPECT_DOUBLE_EQ(axis.place(-3.0), 5.0);
    EXPECT_NEAR(axis.place(1.0), 10.0, 1e-9);
    EXPECT_NEAR(axis.place(10.0), 60.0, 1e-9);
}

TEST(LogAxis, RunsEitherWay) {
    const LogAxis axis(std::vector{1.0, 100.0, 0.0}, 110.0, 0.0, 10.0);

    EXPECT_DOUBLE_EQ(axis.start(), 100.0);
    EXPECT_DOUBLE_EQ(axis.place(0.0), 105.0);
    EXPECT_NEAR(axis.place(10.0), 50.0, 1e-9);
}

TEST(LogAxis, KeepsWhatLiesBeyondAtItsEnd) {
    const LogAxis axis(std::vector{1.0, 100.0}, 0.0, 100.0, 10.0);

    EXPECT_DOUBLE_EQ(axis.place(1e-9), 0.0);
    EXPECT_DOUBLE_EQ(axis.place(1e9), 100.0);
}

TEST(LogAxis, OfOneValueHasALength) {
    const LogAxis axis(std::vector{5.0, 5.0}, 0.0, 100.0, 10.0);

    EXPECT_LT(axis.lowest(), axis.highest());
    EXPECT_GE(axis.place(5.0), 0.0);
}

TEST(LogAxis, OfNothingPositiveStillIsOne) {
    const LogAxis axis(std::vector{0.0}, 0.0, 100.0, 10.0);

    EXPECT_TRUE(axis.knows_zero());
    EXPECT_THAT(labels_of(axis), ElementsAre("0.1", "0.2", "0.5", "1"));
}

TEST(LogAxis, MarksPowersOfTenAndWhenShortTwoAndFiveOfThem) {
    EXPECT_THAT(
        labels_of(LogAxis(std::vector{0.01, 100.0}, 0.0, 1.0, 0.0)),
        ElementsAre("0.01", "0.1", "1", "10", "100"));
    EXPECT_THAT(
        labels_of(LogAxis(std::vector{2.5, 40.0}, 0.0, 1.0, 0.0)),
        ElementsAre("2", "5", "10", "20", "50"));
}

TEST(ChartLabels, LieBesideTheirPoint) {
    const std::vector<chart::Wanted> wanted = {{{50.0, 50.0}, "name"}};
    const std::vector<chart::Box> taken = {chart::mark_box({50.0, 50.0})};

    const auto places = chart::place_labels(wanted, taken, {0.0, 0.0, 200.0, 100.0});

    ASSERT_TRUE(places[0]);
    EXPECT_GT(places[0]->x, 50.0);
}

TEST(ChartLabels, GoToTheOtherSideWhereTheChartEnds) {
    const std::vector<chart::Wanted> wanted = {{{190.0, 50.0}, "name"}};
    const std::vector<chart::Box> taken = {chart::mark_box({190.0, 50.0})};

    const auto places = chart::place_labels(wanted, taken, {0.0, 0.0, 200.0, 100.0});

    ASSERT_TRUE(places[0]);
    EXPECT_LT(places[0]->x, 190.0 - 4 * 5.0);
}

TEST(ChartLabels, CoverNothingThatIsThere) {
    const std::vector<chart::Wanted> wanted = {{{50.0, 50.0}, "name"}};
    const chart::Box right_of_it = {55.0, 0.0, 200.0, 100.0};

    const auto places = chart::place_labels(wanted, {right_of_it}, {0.0, 0.0, 200.0, 100.0});

    ASSERT_TRUE(places[0]);
    EXPECT_LE(chart::text_box(*places[0], "name").right, 55.0);
}

TEST(ChartLabels, AreLeftOutWhereNothingIsFree) {
    const std::vector<chart::Wanted> wanted(9, {{100.0, 50.0}, "the same place again"});
    const std::vector<chart::Box> taken = {chart::mark_box({100.0, 50.0})};

    const auto places = chart::place_labels(wanted, taken, {0.0, 0.0, 400.0, 100.0});

    EXPECT_TRUE(places.front());
    EXPECT_FALSE(places.back());
}

} // namespace
