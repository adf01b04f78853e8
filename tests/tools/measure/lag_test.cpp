#include "tests/support/pictures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "tools/measure/lag.hpp"

namespace measure {
namespace {

/// What is d px wide is that much per px of an upright edge, as its length is measured.
constexpr double kUpright = 4.0 / std::numbers::pi;

/// The true edge at `x`, the drawn one `behind` px behind it.
Comparison frame(double x, double behind) {
    return comparison(
        pictures::draw(160, 64, pictures::upright_edge(x - behind)),
        pictures::draw(160, 64, pictures::upright_edge(x)));
}

/// An edge that moves `speed` px a frame, redrawn every `period` frames, each time `wrong` px
/// beside the true one.
LagFigures lag_of(int period, double speed, double wrong) {
    LagRecorder recorder;
    for (int k = 0; k < 4 * period; ++k) {
        const int age = k % period;
        const double x = 20.0 + speed * k;
        recorder.add(frame(x, wrong + speed * age), frame(x, wrong), std::array<int, 1>{age});
    }
    return recorder.figures();
}

TEST(Lag, OfAnEdgeRedrawnEveryNthFrameIsHalfItsWay) {
    for (const int period : {2, 4, 8}) {
        SCOPED_TRACE(period);
        constexpr double kSpeed = 3.0;
        const LagFigures figures = lag_of(period, kSpeed, 0.0);

        EXPECT_NEAR(figures.stale_px.value(), kUpright * kSpeed * (period - 1) / 2.0, 1e-9);
        EXPECT_EQ(figures.stale_p95_px.value(), kSpeed * (period - 1));
        EXPECT_EQ(figures.age_mean.value(), (period - 1) / 2.0);
        EXPECT_EQ(figures.age_max.value(), period - 1);
    }
}

TEST(Lag, OfWhatIsRedrawnInEveryFrameIsZeroHoweverWrongItIs) {
    const LagFigures figures = lag_of(1, 3.0, 2.0);

    EXPECT_EQ(figures.stale_px.value(), 0.0);
    EXPECT_EQ(figures.stale_p95_px.value(), 0.0);
    EXPECT_EQ(figures.age_max.value(), 0.0);
}

TEST(Lag, LeavesOutWhatTheTechniqueGetsWrongAnyway) {
    const LagFigures figures = lag_of(4, 3.0, 2.0);

    EXPECT_NEAR(figures.stale_px.value(), kUpright * 4.5, 1e-9);
    EXPECT_EQ(figures.stale_p95_px.value(), 9.0);
}

TEST(Lag, OfAnEdgeThatStandsStillIsZero) {
    EXPECT_EQ(lag_of(8, 0.0, 1.0).stale_px.value(), 0.0);
}

TEST(Lag, SaysWhyThereIsNoFigure) {
    LagRecorder recorder;
    recorder.add(comparison(Mask(8, 8), Mask(8, 8)), comparison(Mask(8, 8), Mask(8, 8)), {});
    const LagFigures figures = recorder.figures();

    EXPECT_EQ(figures.stale_px.reason(), "less than 32 px of true edge");
    EXPECT_EQ(figures.stale_p95_px.reason(), "no edge was drawn");
    EXPECT_EQ(figures.age_max.reason(), "nothing had to be drawn");
}

} // namespace
} // namespace measure
