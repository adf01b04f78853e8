// Keyframe sampling in closed form.

#include "engine/scene/animation_clip.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using scene::AnimatedProperty;
using scene::AnimationChannel;
using scene::Interpolation;

std::array<float, 4> at(const AnimationChannel& channel, float time) {
    std::array<float, 4> value = {};
    scene::sample(channel, time, value.data());
    return value;
}

AnimationChannel moving(Interpolation interpolation) {
    return {0, AnimatedProperty::translation, interpolation, {1, 3}, {0, 10, 100, 4, 20, 200}, 3};
}

/// A quarter turn about the y axis in one second.
AnimationChannel turning(Interpolation interpolation) {
    const float half = std::sqrt(0.5F);
    return {
        0, AnimatedProperty::rotation, interpolation, {0, 1}, {0, 0, 0, 1, 0, half, 0, half}, 4};
}

TEST(Sample, StepsHoldTheKeyBefore) {
    EXPECT_EQ(at(moving(Interpolation::step), 2.9F)[0], 0.0F);
    EXPECT_EQ(at(moving(Interpolation::step), 3.0F)[0], 4.0F);
}

TEST(Sample, LinearIsTheMixOfItsKeys) {
    EXPECT_FLOAT_EQ(at(moving(Interpolation::linear), 1.5F)[0], 1.0F);
    EXPECT_FLOAT_EQ(at(moving(Interpolation::linear), 1.5F)[1], 12.5F);
    EXPECT_FLOAT_EQ(at(moving(Interpolation::linear), 1.5F)[2], 125.0F);
}

TEST(Sample, HoldsTheFirstKeyBeforeItAndTheLastAfter) {
    EXPECT_EQ(at(moving(Interpolation::linear), 0.0F)[1], 10.0F);
    EXPECT_EQ(at(moving(Interpolation::linear), 99.0F)[1], 20.0F);
}

TEST(Sample, OneKeyIsAConstant) {
    const AnimationChannel channel{
        0, AnimatedProperty::scale, Interpolation::linear, {2}, {1, 2, 3}, 3};

    EXPECT_EQ(at(channel, 0.0F)[2], 3.0F);
    EXPECT_EQ(at(channel, 5.0F)[2], 3.0F);
}

TEST(Sample, RotationsTurnEvenly) {
    const auto third = at(turning(Interpolation::linear), 1.0F / 3.0F);
    const float angle = 2.0F * std::atan2(third[1], third[3]);

    EXPECT_NEAR(angle, 0.5235988F, 1e-5F); // 30 degrees
}

TEST(Sample, RotationsTakeTheShorterWay) {
    AnimationChannel channel = turning(Interpolation::linear);
    for (std::size_t i = 4; i < 8; ++i)
        channel.values[i] = -channel.values[i]; // the same rotation, the other sign

    const auto middle = at(channel, 0.5F);

    EXPECT_NEAR(std::abs(middle[3]), std::cos(0.3926991F), 1e-5F);
}

TEST(Sample, CubicSplinesAreHermite) {
    // p0 = 1, out-tangent 2, in-tangent -4, p1 = 3, two seconds between.
    const AnimationChannel channel{
        0,
        AnimatedProperty::morph_weights,
        Interpolation::cubic_spline,
        {0, 2},
        {9, 1, 2, -4, 3, 9},
        1};
    const float t = 0.25F;
    const float expected = (2 * t * t * t - 3 * t * t + 1) * 1 + 2 * (t * t * t - 2 * t * t + t) * 2
                           + (3 * t * t - 2 * t * t * t) * 3 + 2 * (t * t * t - t * t) * -4;

    EXPECT_FLOAT_EQ(at(channel, 0.5F)[0], expected);
    EXPECT_FLOAT_EQ(at(channel, 0.0F)[0], 1.0F);
    EXPECT_FLOAT_EQ(at(channel, 2.0F)[0], 3.0F);
}

TEST(Sample, CubicRotationsAreUnit) {
    const float half = std::sqrt(0.5F);
    const AnimationChannel channel{
        0,
        AnimatedProperty::rotation,
        Interpolation::cubic_spline,
        {0, 1},
        {0, 0, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 3, 0, 0, 0, half, 0, half, 0, 0, 0, 0},
        4};
    const auto value = at(channel, 0.4F);

    EXPECT_NEAR(std::hypot(value[1], value[3]), 1.0F, 1e-6F);
    EXPECT_EQ(value[0], 0.0F);
}

TEST(Sample, ARotationThatVanishesKeepsTheKeyBefore) {
    const AnimationChannel channel{
        0,
        AnimatedProperty::rotation,
        Interpolation::cubic_spline,
        {0, 1},
        {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0},
        4};

    EXPECT_EQ(at(channel, 0.5F), (std::array<float, 4>{0, 0, 0, 1}));
}

} // namespace
