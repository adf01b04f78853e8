#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/measure/flip.hpp"
#include "tools/measure/ranks.hpp"

namespace measure {
namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr Color kBlack = {0, 0, 0};
constexpr Color kWhite = {255, 255, 255};

engine::Image uniform(int width, int height, const Color& color) {
    engine::Image image(width, height, 3);
    for (std::size_t i = 0; i < image.bytes.size(); ++i)
        image.bytes[i] = color[i % 3];
    return image;
}

/// `left` up to x, `right` from there on.
engine::Image step(int width, int height, int x, const Color& left, const Color& right) {
    engine::Image image = uniform(width, height, right);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < x; ++column)
            std::copy(left.begin(), left.end(), image.at(column, row));
    return image;
}

/// CIE lightness of a grey. Source: CIE 15, 8.2.1.
double lightness(int byte) {
    const double linear = std::pow((byte / 255.0 + 0.055) / 1.055, 2.4);
    return 116.0 * std::cbrt(linear) - 16.0;
}

/// The largest colour difference, from published values: L*a*b* of the green and the blue primary
/// of sRGB are (87.735, -86.183, 83.180) and (32.297, 79.188, -107.860); colours fade with 0.01 L*:
/// (-75.613, 72.978) and (25.575, -34.836). So 55.438 + sqrt(101.188^2 + 107.814^2) = 203.30.
const double kLargest = std::pow(203.30, 0.7);

double expected(double difference) {
    const double error = std::pow(difference, 0.7);
    const double small = 0.4 * kLargest;
    return error < small ? 0.95 * error / small
                         : 0.95 + 0.05 * (error - small) / (kLargest - small);
}

TEST(Flip, OfAPictureWithItselfIsZero) {
    const engine::Image picture = step(40, 30, 17, {200, 30, 90}, {10, 220, 60});

    for (const float difference : flip(picture, picture))
        EXPECT_EQ(difference, 0.0F);
}

TEST(Flip, OfTwoGreysIsTheirDifferenceInLightnessOnItsScale) {
    struct Pair {
        int a;
        int b;
    };
    for (const Pair pair : {Pair{119, 124}, {60, 180}, {200, 190}, {12, 255}}) {
        SCOPED_TRACE(testing::Message() << pair.a << " to " << pair.b);
        const auto a = static_cast<std::uint8_t>(pair.a);
        const auto b = static_cast<std::uint8_t>(pair.b);

        const auto found = flip(uniform(24, 24, {a, a, a}), uniform(24, 24, {b, b, b}));

        const double wanted = expected(std::abs(lightness(pair.a) - lightness(pair.b)));
        EXPECT_NEAR(mean(found), wanted, 2e-3);
        EXPECT_NEAR(percentile(found, 0.99), percentile(found, 0.01), 1e-4);
    }
}

TEST(Flip, OfBlackAndWhiteIs0Point967) {
    // 100^0.7 = 25.119 of at most 41.27: 0.95 + 0.05 (25.119 - 16.51) / 24.76.
    EXPECT_NEAR(mean(flip(uniform(24, 24, kBlack), uniform(24, 24, kWhite))), 0.9674, 1e-4);
}

TEST(Flip, OfTheGreenAndTheBluePrimaryIsTheLargest) {
    EXPECT_NEAR(mean(flip(uniform(24, 24, {0, 255, 0}), uniform(24, 24, {0, 0, 255}))), 1.0, 1e-4);
}

TEST(Flip, OfTwoColorsAddsLightnessAndFadedColor) {
    // L*a*b* of the red primary of sRGB: (53.237, 80.090, 67.202), faded to (42.638, 35.776). To
    // the green one, see above: 34.498 + sqrt(118.251^2 + 37.202^2) = 158.46.
    const double wanted = expected(158.46);

    EXPECT_NEAR(
        mean(flip(uniform(24, 24, {255, 0, 0}), uniform(24, 24, {0, 255, 0}))), wanted, 1e-3);
}

TEST(Flip, DoesNotDependOnTheOrder) {
    const engine::Image a = step(40, 30, 17, {200, 30, 90}, {10, 220, 60});
    const engine::Image b = step(40, 30, 21, {190, 40, 80}, {30, 210, 60});

    EXPECT_EQ(flip(a, b), flip(b, a));
}

TEST(Flip, OfColorsWithoutEdgesDoesNotDependOnTheSize) {
    const Color a = {120, 80, 200};
    const Color b = {100, 90, 180};
    const double small = mean(flip(uniform(8, 8, a), uniform(8, 8, b)));

    EXPECT_NEAR(mean(flip(uniform(97, 31, a), uniform(97, 31, b))), small, 1e-5);
    EXPECT_GT(small, 0.05);
}

TEST(Flip, OfAnEdgeIsSeenAtTheEdgeAlone) {
    const auto found = flip(step(80, 20, 40, kBlack, kWhite), step(80, 20, 42, kBlack, kWhite));
    const auto at = [&](int x) { return found[static_cast<std::size_t>(10 * 80 + x)]; };

    EXPECT_GT(at(40), 0.5F);
    EXPECT_EQ(at(10), 0.0F);
    EXPECT_EQ(at(75), 0.0F);
}

TEST(Flip, ANewEdgeWeighsMoreThanItsColors) {
    // Against black, on the lit side of the step. The eye's bell for lightness is 1.0339 px wide
    // here, its middle weighs 0.3859: it sees (1 + 0.3859) / 2 of the light, L* 86.65. The first
    // derivative is 1 there, larger than the second, so the exponent is 1 - sqrt(1 / sqrt 2).
    const double wanted = std::pow(expected(86.65), 1.0 - std::pow(2.0, -0.25));
    const auto found = flip(uniform(80, 20, kBlack), step(80, 20, 40, kBlack, kWhite));
    const auto at = [&](int x) {
        return static_cast<double>(found[static_cast<std::size_t>(800 + x)]);
    };

    EXPECT_NEAR(at(75), 0.9674, 1e-3);
    EXPECT_EQ(at(5), 0.0);
    EXPECT_NEAR(at(40), wanted, 1e-4);
    EXPECT_GT(at(40), expected(100.0));
}

TEST(Flip, FineDetailVanishesWhereTheEyeIsFar) {
    engine::Image board(64, 64, 3);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            std::fill_n(board.at(x, y), 3, (x + y) % 2 == 0 ? std::uint8_t{255} : std::uint8_t{0});
    // A board of black and white pixels sends half the light of white: 188 in sRGB.
    const engine::Image grey = uniform(64, 64, {188, 188, 188});
    const auto middle = [](const std::vector<float>& found) { return found[32 * 64 + 32]; };

    EXPECT_LT(middle(flip(board, grey, 200.0)), 0.02F);
    EXPECT_GT(middle(flip(board, grey, 20.0)), 0.5F);
}

} // namespace
} // namespace measure
