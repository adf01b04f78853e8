// The sample's player gets round on its own feet, and what moves by itself stays within bounds.

#include <gtest/gtest.h>

#include "tools/gnomon/play_visitor.hpp"

namespace gnomon {

namespace {

TEST(Visitor, GetsRoundTheSampleWithoutBeingStuck) {
    auto level = load_level(PROJECT_SOURCE_DIR "/games/sample/level.lua");
    ASSERT_TRUE(level) << engine::to_string(level.error());
    Visitor visitor(*level, {64, 36}, 8.0);

    double highest = 0.0;
    double time = 0.0;
    for (; time < 120.0 && visitor.rounds() == 0; time += 0.05) {
        const glm::dvec3 eye = visitor.advance(0.05).position;
        highest = std::max(highest, eye.y);
        ASSERT_LT(std::abs(eye.x), 11.8) << time;
        ASSERT_LT(std::abs(eye.z), 9.0) << time;
        ASSERT_GT(eye.y, 1.3) << time;
    }

    EXPECT_EQ(visitor.rounds(), 1);
    EXPECT_EQ(visitor.missed(), 0);
    EXPECT_NEAR(highest, 1.2 + 1.7, 0.05) << "the terrace was climbed";
    EXPECT_LT(time, 60.0);
}

TEST(Visitor, GetsRoundInLongFramesToo) {
    auto level = load_level(PROJECT_SOURCE_DIR "/games/sample/level.lua");
    ASSERT_TRUE(level);
    Visitor visitor(*level, {64, 36}, 8.0);

    for (double time = 0.0; time < 240.0; time += 0.25) {
        const glm::dvec3 eye = visitor.advance(0.25).position;
        ASSERT_LT(std::abs(eye.x), 11.8) << time;
        ASSERT_LT(std::abs(eye.z), 9.0) << time;
        ASSERT_GT(eye.y, 1.3) << time;
    }

    EXPECT_GE(visitor.rounds(), 2);
}

TEST(Level, TheSampleActsWithoutAMistake) {
    auto level = load_level(PROJECT_SOURCE_DIR "/games/sample/level.lua");
    ASSERT_TRUE(level);
    ASSERT_NE(level->script, nullptr);

    for (int i = 0; i < 40; ++i) { // 20 minutes
        const auto done = level->script->update(level->world, 30.0F);
        ASSERT_TRUE(done) << done.error().message;
    }
}

} // namespace

} // namespace gnomon
