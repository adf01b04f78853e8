#include "tests/support/pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/measure/figures.hpp"

namespace measure {
namespace {

constexpr int kSize = 128;

/// Dark disc in the middle.
Mask disc() {
    return pictures::draw(kSize, kSize, pictures::Ellipse{{64.2, 63.7}, 30.0, 30.0});
}

TEST(Compare, FindsNothingWrongWithACopyOfTheTruth) {
    const Figures figures = compare(comparison(disc(), disc()));

    EXPECT_EQ(figures.valid_px, kSize * kSize);
    EXPECT_EQ(figures.false_shadow_px, 0.0);
    EXPECT_EQ(figures.light_leak_px, 0.0);
    EXPECT_EQ(figures.interior.largest_px, 0.0);
    EXPECT_EQ(figures.interior.components.value(), 0.0);
    EXPECT_EQ(figures.chamfer_px.value(), 0.0);
    EXPECT_EQ(figures.hausdorff95_px.value(), 0.0);
    EXPECT_EQ(figures.boundary_f1.value(), 1.0);
    EXPECT_EQ(figures.error_px, 0.0);
    EXPECT_EQ(figures.eps_px.value(), 0.0);
    EXPECT_EQ(figures.bias_px.value(), 0.0);
    EXPECT_EQ(figures.over_half_pixel_floor.value(), 0.0);
}

TEST(Compare, AsksWhetherATruthBelowThePrecisionFloorWasCopied) {
    Comparison input = comparison(disc(), disc());
    EXPECT_TRUE(compare(input).copied_truth);
    EXPECT_THAT(warnings(compare(input)), testing::ElementsAre(testing::HasSubstr("copied")));

    input.exact_by_construction = true;
    EXPECT_FALSE(compare(input).copied_truth);
}

TEST(Compare, DoesNotSuspectAMaskOneEighthOfAPixelOff) {
    const Mask shifted =
        pictures::draw(kSize, kSize, pictures::Ellipse{{64.325, 63.7}, 30.0, 30.0});

    EXPECT_FALSE(compare(comparison(shifted, disc())).copied_truth);
}

TEST(Compare, CallsAMissingShadowOneLargeLightLeak) {
    const Figures figures = compare(comparison(Mask(kSize, kSize), disc()));

    EXPECT_EQ(figures.false_shadow_px, 0.0);
    EXPECT_NEAR(figures.light_leak_px, 3.14159 * 30.0 * 30.0, 30.0);
    EXPECT_NEAR(figures.interior.light_leak_px, 3.14159 * 29.3 * 29.3, 60.0);
    EXPECT_EQ(figures.interior.largest_px, figures.interior.light_leak_px);
    EXPECT_GT(figures.bias_px.value(), 0.0);
    EXPECT_EQ(figures.boundary_f1.value(), 0.0);
    EXPECT_NEAR(figures.chamfer_px.value(), kSize * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(figures.hausdorff95_px.value(), kSize * std::sqrt(2.0), 1e-9);
}

TEST(Compare, AgreesWhereNeitherMaskHasAnEdge) {
    const Figures figures = compare(comparison(Mask(8, 8), Mask(8, 8)));

    EXPECT_EQ(figures.edge_px, 0.0);
    EXPECT_EQ(figures.boundary_f1.value(), 1.0);
    EXPECT_EQ(figures.chamfer_px.value(), 0.0);
    EXPECT_EQ(figures.hausdorff95_px.value(), 0.0);
    EXPECT_EQ(figures.mean_error.value(), 0.0);
}

TEST(Compare, GivesNoErrorPerEdgeWhereTheEdgeIsShort) {
    const Mask small = pictures::draw(16, 16, pictures::Ellipse{{8.0, 8.0}, 3.0, 3.0});

    const Figures figures = compare(comparison(Mask(16, 16), small));

    EXPECT_FALSE(figures.eps_px.known());
    EXPECT_THAT(figures.eps_px.reason(), testing::HasSubstr("32 px"));
    EXPECT_FALSE(figures.over_precision_floor.known());
    EXPECT_FALSE(figures.copied_truth);
    EXPECT_NEAR(figures.mean_error.value(), figures.light_leak_px / 256.0, 1e-9);
}

TEST(Compare, CountsTheLargestBlobOverCornersToo) {
    Mask measured(32, 32);
    for (const auto& [x, y] : {std::pair(4, 4), {5, 5}, {6, 6}, {7, 5}})
        measured.at(x, y) = 0.0F; // down and up again, joined by corners alone
    measured.at(20, 20) = measured.at(21, 20) = 0.0F;

    const Figures figures = compare(comparison(measured, Mask(32, 32)));

    EXPECT_EQ(figures.interior.false_shadow_px, 6.0);
    EXPECT_EQ(figures.interior.largest_px, 4.0);
    EXPECT_NEAR(figures.interior.components.value(), 2.0 * 1000.0 / 1024.0, 1e-9);
}

TEST(Compare, TellsAcneByManySmallComponents) {
    constexpr int kWide = 256;
    constexpr double kDensity = 0.01;
    engine::Random random(3);
    const Mask measured = pictures::draw(
        kWide, kWide, [&](pictures::Place) { return random.uniform() < kDensity ? 0.0 : 1.0; });

    const Figures figures = compare(comparison(measured, Mask(kWide, kWide)));

    EXPECT_NEAR(figures.interior.false_shadow_px / (kWide * kWide), kDensity, 0.001);
    // Four of the eight neighbours can join a pixel to a component that an earlier pixel started.
    EXPECT_NEAR(
        figures.interior.components.value(), 1000.0 * kDensity * (1.0 - 4.0 * kDensity), 0.7);
    EXPECT_LE(figures.interior.largest_px, 6.0);
}

TEST(Compare, SetsPlainResolutionErrorApartFromStructure) {
    const pictures::StraightEdge truth = pictures::upright_edge(64.0);
    const pictures::StraightEdge shifted = pictures::upright_edge(67.0);
    Comparison input =
        comparison(pictures::draw(kSize, kSize, shifted), pictures::draw(kSize, kSize, truth));
    input.measured.at(100, 40) = 0.0F;
    input.resolution_band_px = {2.5F}; // the band's own end belongs to it

    const Figures figures = compare(input);

    EXPECT_EQ(figures.interior.false_shadow_px, 2.0 * kSize + 1.0);
    EXPECT_EQ(figures.far_false_shadow_px.value(), 1.0);
    EXPECT_EQ(figures.far_largest_px.value(), 1.0);
    EXPECT_EQ(figures.far_light_leak_px.value(), 0.0);
    EXPECT_NEAR(figures.band_share.value(), 6.0 / kSize, 1e-9);
}

TEST(Compare, TakesABandPerPixel) {
    Comparison input = comparison(
        pictures::draw(16, 16, pictures::upright_edge(11.0)),
        pictures::draw(16, 16, pictures::upright_edge(8.0)));
    input.resolution_band_px.assign(256, 0.0F);
    std::fill(input.resolution_band_px.begin(), input.resolution_band_px.begin() + 128, 3.0F);

    EXPECT_EQ(compare(input).far_false_shadow_px.value(), 2.0 * 8.0);
}

TEST(Compare, ForgivesAnErrorInsideTheBandAndNoneOutside) {
    // Dark left of x = 64. Texels of 4 px and a shift of 0.4 px: 3.4 px are forgiven, and so are
    // the columns whose centres lie 0.5, 1.5 and 2.5 px from the edge, on either side of it.
    constexpr double kEdge = 64.0;
    const Mask truth = pictures::draw(kSize, kSize, pictures::upright_edge(kEdge));
    const auto with_error_at = [&](int x) {
        Comparison input = comparison(truth, truth);
        input.measured.at(x, 40) = lit(truth.at(x, 40)) ? 0.0F : 1.0F;
        input.resolution_band_px = {resolution_band_px(4.0, 0.4)};
        return compare(input);
    };

    EXPECT_EQ(with_error_at(66).far_false_shadow_px.value(), 0.0);
    EXPECT_EQ(with_error_at(67).far_false_shadow_px.value(), 1.0);
    EXPECT_EQ(with_error_at(67).far_light_leak_px.value(), 0.0);
    EXPECT_EQ(with_error_at(61).far_light_leak_px.value(), 0.0);
    EXPECT_EQ(with_error_at(60).far_light_leak_px.value(), 1.0);
    EXPECT_EQ(with_error_at(60).far_false_shadow_px.value(), 0.0);
    EXPECT_NEAR(with_error_at(60).band_share.value(), 6.0 / kSize, 1e-9);
}

TEST(Compare, GivesATechniqueWithoutTexelsABandOfOnePixel) {
    Comparison input = comparison(
        pictures::draw(kSize, kSize, pictures::upright_edge(66.0)),
        pictures::draw(kSize, kSize, pictures::upright_edge(64.0)));

    const Figures figures = compare(input);

    EXPECT_EQ(figures.far_false_shadow_px.value(), kSize);
    EXPECT_EQ(figures.far_false_shadow_px.value(), figures.interior.false_shadow_px);
    EXPECT_NEAR(figures.band_share.value(), 2.0 / kSize, 1e-9);
}

TEST(Compare, DoesNotJudgeAPictureThatIsMostlyBand) {
    Comparison input =
        comparison(Mask(kSize, kSize), pictures::draw(kSize, kSize, pictures::upright_edge(64.0)));
    input.resolution_band_px = {0.25F * kSize / 2.0F};
    EXPECT_TRUE(compare(input).far_light_leak_px.known());

    input.resolution_band_px = {0.25F * kSize / 2.0F + 1.0F};
    const Figures figures = compare(input);

    EXPECT_NEAR(figures.band_share.value(), 0.25 + 2.0 / kSize, 1e-9);
    EXPECT_THAT(figures.far_light_leak_px.reason(), testing::HasSubstr("not judged"));
    EXPECT_THAT(figures.far_largest_px.reason(), testing::HasSubstr("not judged"));
}

TEST(Compare, ForgivesWhereAnEdgeIsKnownThatPixelsDoNotShow) {
    Comparison input = comparison(Mask(32, 32), Mask(32, 32));
    input.measured.at(9, 9) = input.measured.at(20, 20) = 0.0F;
    input.hidden_edge.assign(32 * 32, 0);
    input.hidden_edge[input.truth.index(9, 9)] = 1;

    const Figures figures = compare(input);

    EXPECT_EQ(figures.far_false_shadow_px.value(), 1.0);
    EXPECT_EQ(figures.interior.false_shadow_px, 2.0);
}

TEST(FarErrors, AreThePixelsThatTheFiguresCount) {
    Comparison input =
        comparison(Mask(kSize, kSize), pictures::draw(kSize, kSize, pictures::upright_edge(64.0)));
    input.resolution_band_px = {3.0F};

    const std::vector<std::uint8_t> far = far_errors(input);

    EXPECT_EQ(
        static_cast<double>(std::count(far.begin(), far.end(), 1)),
        compare(input).far_light_leak_px.value());
    EXPECT_EQ(far[input.truth.index(60, 5)], 1);
    EXPECT_EQ(far[input.truth.index(61, 5)], 0);
}

TEST(ResolutionBand, IsThreeQuartersOfATexelAndTheShift) {
    EXPECT_EQ(resolution_band_px(0.0, 0.0), 1.0F);
    EXPECT_EQ(resolution_band_px(1.0, 0.1), 1.0F);
    EXPECT_EQ(resolution_band_px(4.0, 0.5), 3.5F);
}

TEST(Compare, LeavesOutWhatIsNotValidAndReportsItsShare) {
    Comparison input = comparison(Mask(10, 10, 0.0F), Mask(10, 10));
    for (std::size_t i = 0; i < 100; ++i)
        input.kind[i] = i < 20   ? PixelKind::empty
                        : i < 24 ? PixelKind::mismatch
                        : i < 32 ? PixelKind::undecided
                        : i < 35 ? PixelKind::grazing
                        : i < 40 ? PixelKind::facing_away
                                 : PixelKind::valid;

    const Figures figures = compare(input);

    EXPECT_EQ(figures.valid_px, 60.0);
    EXPECT_EQ(figures.false_shadow_px, 60.0);
    EXPECT_EQ(figures.error_px, 60.0);
    EXPECT_EQ(figures.grazing_px, 3.0);
    EXPECT_EQ(figures.grazing_wrong_px, 3.0);
    EXPECT_NEAR(figures.invalid_share.value(), 0.05, 1e-9);
    EXPECT_NEAR(figures.undecided_share.value(), 0.1, 1e-9);
    EXPECT_EQ(warnings(figures).size(), 2U);
}

TEST(Compare, DoesNotCountUndecidedPixelsAtAnEdge) {
    const Mask mask = pictures::draw(16, 16, pictures::upright_edge(8.0));
    Comparison input = comparison(mask, mask);
    input.kind[mask.index(8, 3)] = PixelKind::undecided;

    EXPECT_EQ(compare(input).undecided_share.value(), 0.0);
}

TEST(Compare, SaysWhyNothingIsKnownWithoutValidPixels) {
    Comparison input = comparison(Mask(4, 4), Mask(4, 4, 0.0F));
    input.kind.assign(16, PixelKind::empty);

    const Figures figures = compare(input);

    EXPECT_EQ(figures.mean_error.reason(), "no valid pixels");
    EXPECT_EQ(figures.interior.components.reason(), "no valid pixels");
    EXPECT_EQ(figures.invalid_share.reason(), "no surface in the picture");
    EXPECT_EQ(figures.light_leak_px, 0.0);
}

TEST(Compare, TakesPicturesOfOnePixelAndOfNone) {
    EXPECT_EQ(compare(comparison(Mask(1, 1), Mask(1, 1, 0.0F))).interior.light_leak_px, 1.0);
    EXPECT_EQ(compare(comparison(Mask(0, 0), Mask(0, 0))).valid_px, 0.0);
}

TEST(Compare, FindsADarkPatchThatWasDarkenedTwice) {
    Mask truth(20, 20);
    for (int y = 0; y < 20; ++y)
        truth.at(3, y) = 0.0F;
    Comparison input = comparison(truth, truth);
    for (int y = 0; y < 20; ++y)
        input.kind[truth.index(10, y)] = PixelKind::facing_away;
    input.picture = engine::Image(20, 20, 3);
    std::fill(input.picture.bytes.begin(), input.picture.bytes.end(), 51);
    input.reference_picture = input.picture;
    const auto darken = [&](int x, int y, int by) {
        for (int channel = 0; channel < 3; ++channel)
            input.picture.at(x, y)[channel] = static_cast<std::uint8_t>(51 - by);
    };
    darken(3, 0, 25);  // in the shadow: counts
    darken(10, 5, 25); // turned away: counts
    darken(3, 1, 1);   // within the tolerance
    darken(15, 5, 25); // lit by right: another figure's business

    EXPECT_EQ(compare(input).double_dark_px.value(), 2.0);
    EXPECT_FALSE(compare(comparison(truth, truth)).double_dark_px.known());
}

} // namespace
} // namespace measure
