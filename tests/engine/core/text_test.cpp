#include "engine/core/text.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

constexpr std::array<std::string_view, 4> kFields = {"radius", "range", "color", "on"};

TEST(NearestWord, ForgivesASwapAMissingAWrongAndASuperfluousLetter) {
    EXPECT_EQ(engine::nearest_word("raduis", kFields), "radius");
    EXPECT_EQ(engine::nearest_word("radus", kFields), "radius");
    EXPECT_EQ(engine::nearest_word("rangr", kFields), "range");
    EXPECT_EQ(engine::nearest_word("collor", kFields), "color");
}

TEST(NearestWord, FindsTheWordItself) {
    EXPECT_EQ(engine::nearest_word("range", kFields), "range");
}

TEST(NearestWord, AllowsOneSlipInAShortWord) {
    EXPECT_EQ(engine::nearest_word("om", kFields), "on");
}

TEST(NearestWord, DoesNotGuessWhenTheWordIsFarFromAll) {
    EXPECT_EQ(engine::nearest_word("texture", kFields), std::nullopt);
    EXPECT_EQ(engine::nearest_word("radius", {}), std::nullopt);
}

TEST(NearestWord, TakesTheFirstOfEquals) {
    constexpr std::array<std::string_view, 2> words = {"cast", "cost"};

    EXPECT_EQ(engine::nearest_word("cust", words), "cast");
}

TEST(DidYouMean, IsTheEndOfAMessageOrNothing) {
    EXPECT_EQ(engine::did_you_mean("raduis", kFields), "; did you mean 'radius'?");
    EXPECT_EQ(engine::did_you_mean("texture", kFields), "");
}

} // namespace
