#include "engine/core/random.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

TEST(Random, GivesThePublishedSequence) {
    // Seed 42, stream 54: the demonstration of the pcg-c-basic sources.
    engine::Random random(42, 54);

    constexpr std::array<std::uint32_t, 6> kExpected = {
        0xa15c02b7U, 0x7b47f409U, 0xba1d3330U, 0x83d2f293U, 0xbfa4784bU, 0xcbed606eU};
    for (const std::uint32_t expected : kExpected)
        EXPECT_EQ(random.next(), expected);
}

TEST(Random, StaysInsideItsBounds) {
    engine::Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        const double uniform = random.uniform();
        const double scaled = random.uniform(-2.0, 3.0);
        ASSERT_TRUE(uniform >= 0.0 && uniform < 1.0);
        ASSERT_TRUE(scaled >= -2.0 && scaled < 3.0);
        ASSERT_LT(random.below(7), 7U);
    }
}

TEST(Random, FillsItsRangeEvenly) {
    engine::Random random(2);
    std::array<int, 10> counts = {};
    for (int i = 0; i < 100'000; ++i)
        ++counts[random.below(10)];

    // Ten thousand each; the standard deviation is 95.
    for (const int count : counts)
        EXPECT_NEAR(count, 10'000, 500);
}

TEST(Random, SeedsAndStreamsGiveDifferentNumbers) {
    engine::Random first(1);
    engine::Random second(2);
    engine::Random other_stream(1, 2);

    const std::uint32_t number = first.next();
    EXPECT_NE(number, second.next());
    EXPECT_NE(number, other_stream.next());
}

} // namespace
