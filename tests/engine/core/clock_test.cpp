#include "engine/core/clock.hpp"

#include <gtest/gtest.h>

namespace engine {
namespace {

TEST(FixedClock, KeepsTheRestForTheNextFrame) {
    FixedClock clock(0.25);

    EXPECT_EQ(clock.advance(0.6), 2);
    EXPECT_NEAR(clock.fraction(), 0.4, 1e-12);
    EXPECT_EQ(clock.advance(0.2), 1);
    EXPECT_EQ(clock.step_count(), 3U);
}

TEST(FixedClock, TellsSimulatedTimeWithoutDrift) {
    FixedClock clock(0.1);

    for (int i = 0; i < 1000; ++i)
        clock.advance(0.1000001);

    EXPECT_EQ(clock.time(), 1000 * 0.1);
}

TEST(FixedClock, DropsTimeThatASlowFrameCannotCatchUp) {
    FixedClock clock(0.25, 4);

    EXPECT_EQ(clock.advance(60.0), 4);
    EXPECT_EQ(clock.advance(0.0), 0);
    EXPECT_EQ(clock.time(), 1.0);
}

} // namespace
} // namespace engine
