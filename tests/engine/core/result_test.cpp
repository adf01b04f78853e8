#include "engine/core/check.hpp"
#include "engine/core/result.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace {

using engine::Error;
using engine::Result;

Result<int> half(int number) {
    if (number % 2 != 0)
        return Error{"found an odd number, expected an even one", {"numbers.lua", 3}};
    return number / 2;
}

TEST(Result, HoldsTheValueOfASuccess) {
    const Result<int> result = half(8);

    ASSERT_TRUE(result);
    EXPECT_EQ(*result, 4);
}

TEST(Result, HoldsTheErrorOfAFailure) {
    const Result<int> result = half(7);

    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(
        to_string(result.error()), "numbers.lua:3: found an odd number, expected an even one");
}

TEST(Result, MovesOutWhatOnlyMoves) {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(3);

    const std::unique_ptr<int> value = *std::move(result);

    EXPECT_EQ(*value, 3);
}

TEST(Result, OfNothingIsASuccessUnlessItHoldsAnError) {
    const Result<void> good;
    const Result<void> bad = Error{"the disk is full"};

    EXPECT_TRUE(good);
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.error().message, "the disk is full");
}

TEST(Error, SaysTheFileAndTheLineWhereTheyAreKnown) {
    EXPECT_EQ(to_string(Error{"message"}), "message");
    EXPECT_EQ(to_string(Error{"message", {"a.lua"}}), "a.lua: message");
    EXPECT_EQ(to_string(Error{"message", {"a.lua", 12}}), "a.lua:12: message");
}

TEST(CheckDeathTest, PrintsTheExpressionAndBothValues) {
    const int found = 3;

    EXPECT_DEATH(
        CHECK_EQ(found, 4), "result_test.cpp:[0-9]+: CHECK\\(found == 4\\) failed: 3 against 4");
    EXPECT_DEATH(CHECK(found > 4), "CHECK\\(found > 4\\) failed");
}

} // namespace
