// What a frame becomes on a chart.

#include "systems/shadows/cost_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/gnomon/chart_points.hpp"

namespace {

using measure::PixelKind;

/// A row of pixels, each with what was drawn, what is true, and what it may be used for.
struct Pixel {
    float drawn;
    float truth;
    PixelKind kind = PixelKind::valid;
};

measure::Comparison row_of(const std::vector<Pixel>& pixels) {
    measure::Mask drawn(static_cast<int>(pixels.size()), 1);
    measure::Mask truth = drawn;
    std::vector<PixelKind> kinds;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        drawn.visibility[i] = pixels[i].drawn;
        truth.visibility[i] = pixels[i].truth;
        kinds.push_back(pixels[i].kind);
    }
    measure::Comparison comparison = measure::comparison(drawn, truth);
    comparison.kind = kinds;
    return comparison;
}

TEST(ChartErrors, CallWrongWhatDiffersByMoreThanAHalf) {
    const chart::Errors errors = gnomon::errors_of(
        row_of({{1.0F, 0.0F}, {0.0F, 1.0F}, {128.0F / 255.0F, 0.0F}, {0.51F, 0.0F}, {1.0F, 1.0F}}),
        {});

    EXPECT_EQ(errors.valid_px, 5.0);
    EXPECT_EQ(errors.wrong_px, 3.0); // a filter's half, rounded to eight bits, is not
}

TEST(ChartErrors, CountUndecidedPixelsAndNoOthers) {
    const chart::Errors errors = gnomon::errors_of(
        row_of(
            {{1.0F, 0.0F, PixelKind::undecided},
             {1.0F, 0.0F, PixelKind::grazing},
             {1.0F, 0.0F, PixelKind::facing_away},
             {1.0F, 0.0F, PixelKind::mismatch},
             {1.0F, 0.0F, PixelKind::empty}}),
        {});

    EXPECT_EQ(errors.valid_px, 1.0);
    EXPECT_EQ(errors.wrong_px, 1.0);
}

TEST(ChartErrors, TakeFloorsThatAreNotKnownForNone) {
    measure::Figures figures;
    figures.precision_floor_px = measure::Figure::missing("too few edges");
    figures.half_pixel_floor_px = 7.0;

    const chart::Errors errors = gnomon::errors_of(row_of({{1.0F, 1.0F}}), figures);

    EXPECT_EQ(errors.precision_floor_px, 0.0);
    EXPECT_EQ(errors.half_pixel_floor_px, 7.0);
}

TEST(ChartCost, IsWhatShadowsAddAtCommittedCoefficients) {
    const gpu::Counters without = {.draws = 3, .triangles = 1000, .mask_fragments = 10};
    const gpu::Counters with = {
        .draws = 5,
        .triangles = 3000,
        .map_texels = 1000000,
        .mask_fragments = 1000010,
        .stencil_fragments = 2000000,
        .taps = 500000};
    const shadows::Cost per = shadows::llvmpipe_profile().ms_per;

    const double ms = gnomon::counted_ms(gnomon::added_by_shadows(with, without), {}, 0);

    EXPECT_DOUBLE_EQ(
        ms,
        2 * per.draws + 1.5 * 2000 * per.vertices + 1e6 * per.map_texels
            + 1e6 * per.colour_fragments + 2e6 * per.stencil_fragments + 5e5 * per.taps);
}

TEST(ChartCost, OfRaysIsWhatThePlansPredict) {
    shadows::FramePlan plan;
    plan.plans.resize(2);
    for (shadows::Plan& pair : plan.plans) {
        pair.entries.emplace_back();
        pair.entries.back().predicted.cost.rays = 1e5;
        pair.entries.back().predicted.cost.taps = 1e9; // counted, not predicted
    }

    const double per_ray = shadows::llvmpipe_profile().ms_per.rays;

    EXPECT_DOUBLE_EQ(gnomon::counted_ms({}, plan, 1000000), 2e5 * per_ray);
    EXPECT_DOUBLE_EQ(gnomon::counted_ms({}, plan, 5000), 2 * 5000 * per_ray); // two a pixel
}

} // namespace
