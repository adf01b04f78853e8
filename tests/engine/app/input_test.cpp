#include "engine/app/input.hpp"

#include <gtest/gtest.h>

namespace app {
namespace {

TEST(Input, AKeyIsPressedForOneFrameAndReleasedForOne) {
    ScriptedInput hands;
    Input input;

    hands.press(Key::e);
    input.advance(hands.take());
    EXPECT_TRUE(input.pressed(Key::e));
    EXPECT_TRUE(input.down(Key::e));

    input.advance(hands.take());
    EXPECT_FALSE(input.pressed(Key::e));
    EXPECT_TRUE(input.down(Key::e));

    hands.release(Key::e);
    input.advance(hands.take());
    EXPECT_TRUE(input.released(Key::e));
    EXPECT_FALSE(input.down(Key::e));

    input.advance(hands.take());
    EXPECT_FALSE(input.released(Key::e));
}

TEST(Input, TheFirstFrameDoesNotJumpToThePointer) {
    ScriptedInput hands;
    Input input;
    hands.move_pointer({400.0F, 300.0F});

    input.advance(hands.take());
    EXPECT_EQ(input.pointer_delta_px(), glm::vec2(0.0F));

    hands.move_pointer({410.0F, 295.0F});
    input.advance(hands.take());
    EXPECT_EQ(input.pointer_delta_px(), glm::vec2(10.0F, -5.0F));
}

TEST(Input, TheWheelTurnsInOneFrameOnly) {
    ScriptedInput hands;
    Input input;
    hands.turn_wheel(2.0F);

    input.advance(hands.take());
    EXPECT_EQ(input.wheel(), 2.0F);

    input.advance(hands.take());
    EXPECT_EQ(input.wheel(), 0.0F);
}

TEST(Input, AStickAtRestIsStillAndAFullTiltIsOne) {
    ScriptedInput hands;
    Input input;

    hands.tilt(Axis::right_x, 0.1F);
    hands.tilt(Axis::right_y, -1.0F);
    input.advance(hands.take());

    EXPECT_EQ(input.axis(Axis::right_x), 0.0F);
    EXPECT_FLOAT_EQ(input.axis(Axis::right_y), -1.0F);
}

TEST(Input, WalkingAslantIsNoFaster) {
    ScriptedInput hands;
    Input input;
    hands.press(Key::w);
    hands.press(Key::right);

    input.advance(hands.take());

    EXPECT_FLOAT_EQ(glm::length(input.walk()), 1.0F);
    EXPECT_GT(input.walk().x, 0.0F);
    EXPECT_GT(input.walk().y, 0.0F);
}

TEST(Input, OppositeKeysCancel) {
    ScriptedInput hands;
    Input input;
    hands.press(Key::a);
    hands.press(Key::d);

    input.advance(hands.take());

    EXPECT_EQ(input.walk(), glm::vec2(0.0F));
}

TEST(Key, HasANameThatLeadsBackToIt) {
    EXPECT_EQ(name(Key::left_shift), "left_shift");
    EXPECT_EQ(key_named("0"), Key::digit_0);
    EXPECT_EQ(key_named("pad_left"), Key::pad_left);
    EXPECT_EQ(key_named("hyper"), std::nullopt);
}

} // namespace
} // namespace app
