#include <gtest/gtest.h>

#include <string>

#include "tools/measure/mask.hpp"

namespace measure {
namespace {

struct Case {
    std::string name;
    PixelEvidence evidence;
    PixelKind expected;
};

class Classify : public testing::TestWithParam<Case> {};

TEST_P(Classify, NamesWhatThePixelMayBeUsedFor) {
    EXPECT_EQ(classify(GetParam().evidence), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Pixels,
    Classify,
    testing::Values(
        Case{"SameSurface", {3, 3, 10.0F, 10.005F, 0.5F}, PixelKind::valid},
        Case{"OtherEntity", {3, 4, 10.0F, 10.0F, 0.5F}, PixelKind::mismatch},
        Case{"SurfaceAgainstSky", {3, 0, 10.0F, 0.0F, 0.5F}, PixelKind::mismatch},
        Case{"OtherDepth", {3, 3, 10.0F, 10.02F, 0.5F}, PixelKind::mismatch},
        Case{"SkyInBoth", {0, 0, 0.0F, 0.0F, 1.0F}, PixelKind::empty},
        Case{"TurnedAway", {3, 3, 10.0F, 10.0F, 0.0F}, PixelKind::facing_away},
        Case{"Grazing", {3, 3, 10.0F, 10.0F, 0.017F}, PixelKind::grazing},
        Case{"JustAboveGrazing", {3, 3, 10.0F, 10.0F, 0.018F}, PixelKind::valid},
        Case{"Undecided", {3, 3, 10.0F, 10.0F, 0.5F, true}, PixelKind::undecided},
        Case{"UndecidedAndTurnedAway", {3, 3, 10.0F, 10.0F, -0.5F, true}, PixelKind::facing_away}),
    [](const testing::TestParamInfo<Case>& tested) { return tested.param.name; });

TEST(MaskFromImage, ReadsTheFirstChannelTopRowFirst) {
    engine::Image image(2, 2, 3);
    *image.at(1, 0) = 255;

    const Mask mask = mask_from_image(image);

    EXPECT_EQ(mask.visibility, (std::vector<float>{0.0F, 1.0F, 0.0F, 0.0F}));
}

TEST(ComparisonDeathTest, RefusesMasksOfDifferentSizes) {
    EXPECT_DEATH(comparison(Mask(2, 2), Mask(3, 2)), "against");
}

} // namespace
} // namespace measure
