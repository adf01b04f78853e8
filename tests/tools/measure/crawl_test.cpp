#include "tests/support/pictures.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tools/measure/crawl.hpp"

namespace measure {
namespace {

/// An upright edge crosses one grid line a pixel, and Crofton's formula counts pi / 4 for each:
/// what is d px wide is 4 / pi d per px of edge.
constexpr double kUpright = 4.0 / std::numbers::pi;

/// A frame whose true edge stands at `x`, the drawn one `offset` px to the right (too dark).
Comparison frame(double x, double offset) {
    return comparison(
        pictures::draw(96, 96, pictures::upright_edge(x + offset)),
        pictures::draw(96, 96, pictures::upright_edge(x)));
}

template <class Offset>
double crawl_of(int frames, double speed, Offset offset) {
    CrawlRecorder recorder;
    for (int k = 0; k < frames; ++k)
        recorder.add(frame(30.0 + speed * k, offset(k)));
    return recorder.figure().value();
}

TEST(Crawl, OfAnEdgeThatStandsBesideTheTrueOneIsZero) {
    EXPECT_EQ(crawl_of(8, 0.0, [](int) { return 3.0; }), 0.0);
}

TEST(Crawl, OfAnEdgeThatFollowsTheTrueOneIsZero) {
    EXPECT_NEAR(crawl_of(30, 1.0, [](int) { return 3.0; }), 0.0, 1e-9);
}

TEST(Crawl, OfAnEdgeThatGoesToAndFroIsItsStep) {
    const auto alternating = [](int k) { return k % 2 == 0 ? 2.0 : -1.0; };

    EXPECT_NEAR(crawl_of(9, 0.0, alternating), kUpright * 3.0, 1e-9);
}

TEST(Crawl, OfAMovingEdgeThatGoesToAndFroIsItsStepToo) {
    const auto alternating = [](int k) { return k % 2 == 0 ? 1.0 : -1.0; };

    EXPECT_NEAR(crawl_of(20, 1.0, alternating), kUpright * 2.0, 1e-9);
}

TEST(Crawl, OfStepsNowAndThenIsTheirMeanSquare) {
    // Of 8 changes, one of 4 px and one back.
    const auto once = [](int k) { return k == 4 ? 4.0 : 0.0; };

    EXPECT_NEAR(crawl_of(9, 0.0, once), kUpright * std::sqrt((16.0 + 16.0) / 8.0), 1e-9);
}

TEST(Crawl, OfSlantedEdgesIsTheStepAcrossThem) {
    // Crofton's formula is right on average over directions only: here it is right to 12 %.
    constexpr double kAngle = 0.4;
    CrawlRecorder recorder;
    for (int k = 0; k < 10; ++k) {
        const pictures::Place normal = pictures::unit(kAngle);
        const double middle = 48.0 * (normal.x + normal.y);
        recorder.add(comparison(
            pictures::draw(
                96, 96, pictures::StraightEdge{normal, middle + (k % 2 == 0 ? 3.0 : -3.0)}),
            pictures::draw(96, 96, pictures::StraightEdge{normal, middle})));
    }

    EXPECT_NEAR(recorder.figure().value(), 6.0, 1.2);
}

TEST(Crawl, AWrongPictureFarFromEveryEdgeIsNoCrawl) {
    CrawlRecorder recorder;
    for (int k = 0; k < 4; ++k) {
        Comparison now = frame(30.0, 0.0);
        if (k % 2 == 1)
            for (int y = 40; y < 50; ++y)
                now.measured.at(80, y) = 0.0F;
        recorder.add(now);
    }

    EXPECT_EQ(recorder.figure().value(), 0.0);
}

TEST(Crawl, NeedsTwoFramesAndAnEdge) {
    CrawlRecorder recorder;
    EXPECT_EQ(recorder.figure().reason(), "fewer than two frames");
    recorder.add(comparison(Mask(32, 32), Mask(32, 32)));
    recorder.add(comparison(Mask(32, 32), Mask(32, 32)));

    EXPECT_EQ(recorder.figure().reason(), "no tile of 16 px keeps 8 px of true edge");
}

} // namespace
} // namespace measure
