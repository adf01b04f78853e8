// Which points are worth their cost.

#include "engine/core/random.hpp"
#include "tests/tools/chart/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/chart/pareto.hpp"

namespace {

using chart::Place;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ParetoFront, LeavesOutWhatIsDearerAndWorse) {
    const std::vector<Place> places = {{3.0, 3.0}, {1.0, 5.0}, {2.0, 6.0}, {5.0, 1.0}, {6.0, 1.0}};

    EXPECT_THAT(chart::pareto_front(places), ElementsAre(1, 0, 3));
}

TEST(ParetoFront, KeepsEqualPoints) {
    const std::vector<Place> places = {{1.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}};

    EXPECT_THAT(chart::pareto_front(places), ElementsAre(0, 1));
}

TEST(ParetoFront, OfNothingIsEmpty) {
    EXPECT_THAT(chart::pareto_front({}), IsEmpty());
}

/// As it is defined, in quadratic time.
bool is_beaten(const Place& place, const std::vector<Place>& by) {
    return std::any_of(by.begin(), by.end(), [&](const Place& other) {
        return other.x <= place.x && other.y <= place.y && (other.x < place.x || other.y < place.y);
    });
}

TEST(ParetoFront, HoldsExactlyWhatNobodyBeats) {
    engine::Random random(5);
    for (int round = 0; round < 50; ++round) {
        SCOPED_TRACE(round);
        std::vector<Place> places(40);
        for (Place& place : places)
            place = {double(random.below(12)), double(random.below(12))};

        const auto front = chart::pareto_front(places);

        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool is_in = std::find(front.begin(), front.end(), i) != front.end();
            EXPECT_NE(is_in, is_beaten(places[i], places)) << i;
        }
        EXPECT_TRUE(std::is_sorted(
            front.begin(), front.end(), [&](auto a, auto b) { return places[a].x < places[b].x; }));
    }
}

TEST(ParetoFront, OfAChartLeavesTheTruthOutAndHoldsPeersAgainstPeers) {
    chart::Findings findings = chart_test::findings();
    chart::Chart& one = findings.charts[0];
    one.points[5].measured_ms = 0.5; // the truth, cheaper than all

    const auto front = chart::on_front(one, chart::Across::measured, chart::Up::wrong_percent);

    // none, the maps of 256 and 1024, volume, auto@8 and the peer; neither map@4096 nor auto@0.1,
    // which are dearer than volumes and worse.
    EXPECT_THAT(front, ElementsAre(true, true, true, false, true, false, false, true, true));
}

TEST(ParetoFront, TakesACostBelowZeroForNone) {
    chart::Chart one;
    one.points = {chart_test::point("a", -0.5, 10.0), chart_test::point("b", 0.0, 5.0)};

    EXPECT_THAT(
        chart::on_front(one, chart::Across::measured, chart::Up::wrong_percent),
        ElementsAre(false, true));
}

} // namespace
