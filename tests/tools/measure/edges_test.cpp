#include "engine/core/random.hpp"
#include "tests/support/pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tools/measure/edges.hpp"

namespace measure {
namespace {

std::vector<PixelKind> all_valid(const Mask& mask) {
    return std::vector<PixelKind>(mask.pixel_count(), PixelKind::valid);
}

TEST(Cracks, LieBetweenLitAndDarkNeighbours) {
    Mask mask(3, 3);
    mask.at(1, 1) = 0.0F;

    const std::vector<Crack> found = cracks(mask, all_valid(mask));

    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].x, 2);
    EXPECT_EQ(found[0].y, 3);
    EXPECT_EQ(found[3].x, 3);
    EXPECT_EQ(found[3].y, 4);
}

TEST(Cracks, FollowTheHalfLitLineOfASoftEdge) {
    const Mask mask = pictures::draw(16, 4, pictures::upright_edge(8.0, 6.0));

    const std::vector<Crack> found = cracks(mask, all_valid(mask));

    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].x, 16);
}

TEST(Cracks, NeedValidPixelsOnBothSides) {
    const Mask mask = pictures::draw(8, 1, pictures::upright_edge(4.0));
    std::vector<PixelKind> kind = all_valid(mask);
    kind[4] = PixelKind::mismatch;

    EXPECT_TRUE(cracks(mask, kind).empty());
}

TEST(Cracks, AreNotInterruptedByOneUndecidedPixel) {
    const Mask mask = pictures::draw(8, 1, pictures::upright_edge(4.0));
    std::vector<PixelKind> kind = all_valid(mask);
    kind[4] = PixelKind::undecided;

    const std::vector<Crack> found = cracks(mask, kind);

    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].x, 8);
}

TEST(Cracks, DoNotSurroundAnUndecidedPixelInTheOpen) {
    Mask mask(5, 5);
    mask.at(2, 2) = 0.0F;
    std::vector<PixelKind> kind = all_valid(mask);
    kind[mask.index(2, 2)] = PixelKind::undecided;

    EXPECT_TRUE(cracks(mask, kind).empty());
}

TEST(CroftonLength, IsTheCircumferenceOfACircle) {
    const pictures::Ellipse circle = {{64.3, 63.8}, 50.0, 50.0};
    const Mask mask = pictures::draw(128, 128, circle);

    const double length = crofton_length(cracks(mask, all_valid(mask)).size());

    EXPECT_NEAR(length / (2.0 * std::numbers::pi * 50.0), 1.0, 0.01);
}

TEST(DistanceField, EqualsTheDistanceByBruteForce) {
    constexpr int kWidth = 23;
    constexpr int kHeight = 17;
    engine::Random random(7);
    std::vector<Crack> sites;
    for (int i = 0; i < 9; ++i)
        sites.push_back(
            {static_cast<int>(random.below(2 * kWidth + 1)),
             static_cast<int>(random.below(2 * kHeight + 1))});

    const DistanceField field(kWidth, kHeight, sites);

    for (int y = 0; y <= 2 * kHeight; ++y)
        for (int x = 0; x <= 2 * kWidth; ++x) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Crack& site : sites)
                nearest = std::min(nearest, 0.5 * std::hypot(x - site.x, y - site.y));
            ASSERT_NEAR(static_cast<double>(field.to({x, y})), nearest, 1e-5) << x << ' ' << y;
        }
}

TEST(DistanceField, IsInfiniteWithoutCracks) {
    const DistanceField field(4, 4, {});

    EXPECT_TRUE(std::isinf(field.to_pixel(2, 2)));
}

} // namespace
} // namespace measure
