// Constants of sampled edges, found again by simulation. A measure that reproduces them measures
// what it says.

#include "tests/support/pictures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

#include "tools/measure/figures.hpp"
#include "tools/measure/floors.hpp"

namespace measure {
namespace {

/// Sums over many pictures, divided once at the end, so that short edges weigh little.
struct Totals {
    double wrong_px = 0.0;
    double error_px = 0.0;
    double edge_px = 0.0;
    double half_pixel_floor_px = 0.0;

    void add(const Figures& figures) {
        wrong_px += figures.false_shadow_px + figures.light_leak_px;
        error_px += figures.error_px;
        edge_px += figures.edge_px;
    }
};

struct Filter {
    std::string name;
    int taps;
    double error;         ///< |V - V*| per px of edge, in texels
    double misclassified; ///< wrong pixels per px of edge, in texels

    friend std::ostream& operator<<(std::ostream& out, const Filter& filter) {
        return out << filter.name;
    }
};

class MapConstants : public testing::TestWithParam<Filter> {};

TEST_P(MapConstants, OfEdgesOfAllDirections) {
    constexpr int kSize = 64;
    constexpr double kTexel = 4.0;
    constexpr int kTrials = 90;
    engine::Random random(11);
    Totals totals;
    for (int trial = 0; trial < kTrials; ++trial) {
        const pictures::StraightEdge truth = pictures::turned_edge(trial, kTrials, kSize, random);
        const pictures::Grid grid = pictures::random_grid(kTexel, random);
        const auto map = pictures::through_map(truth, grid, GetParam().taps);
        totals.add(compare(
            comparison(pictures::draw(kSize, kSize, map), pictures::draw(kSize, kSize, truth))));
    }

    EXPECT_NEAR(totals.wrong_px / totals.edge_px / kTexel, GetParam().misclassified, 0.008);
    EXPECT_NEAR(totals.error_px / totals.edge_px / kTexel, GetParam().error, 0.008);
}

INSTANTIATE_TEST_SUITE_P(
    Filters,
    MapConstants,
    testing::Values(
        Filter{"Nearest", 0, 0.2422, 0.2422},
        Filter{"Bilinear", 1, 0.332, 0.188},
        Filter{"Pcf3x3", 3, 0.762, 0.112}),
    [](const testing::TestParamInfo<Filter>& tested) { return tested.param.name; });

TEST(EdgeConstants, TwoCentredRampsDifferByAQuarterOfTheirWidths) {
    const pictures::StraightEdge wide = {pictures::unit(0.7), 90.0, 20.0};
    pictures::StraightEdge narrow = wide;
    narrow.width = 8.0;

    const Figures figures =
        compare(comparison(pictures::draw(128, 128, narrow), pictures::draw(128, 128, wide), true));

    // Crofton's length holds for edges of all directions: this one has its own factor.
    const double direction = std::numbers::pi / 4.0 * (std::cos(0.7) + std::sin(0.7));
    EXPECT_NEAR(figures.eps_px.value() * direction, 12.0 / 4.0, 0.06);
    EXPECT_NEAR(figures.bias_px.value(), 0.0, 0.05);
}

TEST(EdgeConstants, AHardShadowOfASoftLightIsWrongByAQuarterOfThePenumbra) {
    const pictures::StraightEdge soft = pictures::upright_edge(64.0, 20.0);
    const pictures::StraightEdge hard = pictures::upright_edge(64.0);

    const Figures figures =
        compare(comparison(pictures::draw(128, 128, hard), pictures::draw(128, 128, soft), true));

    EXPECT_NEAR(figures.error_px / 128.0, 20.0 / 4.0, 1e-3);
    EXPECT_NEAR(figures.penumbra_px, 20.0 * 128.0, 1e-9);
}

TEST(EdgeConstants, AShiftedRampIsWrongByItsShiftWhateverItsWidth) {
    for (const double width : {4.0, 16.0, 40.0}) {
        SCOPED_TRACE(width);
        const pictures::StraightEdge truth = pictures::upright_edge(64.0, width);
        const pictures::StraightEdge shifted = pictures::upright_edge(65.5, width);

        const Figures figures = compare(
            comparison(pictures::draw(128, 128, shifted), pictures::draw(128, 128, truth), true));

        EXPECT_NEAR(figures.error_px / 128.0, 1.5, 1e-3);
        EXPECT_NEAR(figures.bias_px.value() * figures.edge_px / 128.0, -1.5, 1e-3);
    }
}

/// An edge of all directions moved by a distance in eight directions.
struct Shift {
    std::string name;
    double distance_px;
    double chamfer_px;
    double hausdorff95_px;
    double boundary_f1;

    friend std::ostream& operator<<(std::ostream& out, const Shift& shift) {
        return out << shift.name;
    }
};

class ShiftedEllipse : public testing::TestWithParam<Shift> {};

TEST_P(ShiftedEllipse, HasTheFloorsOfItsShift) {
    constexpr int kDirections = 8;
    const pictures::Ellipse truth = {{80.27, 79.61}, 50.0, 30.0, 0.4};
    const Mask true_mask = pictures::draw(160, 160, truth);
    Totals totals;
    double chamfer = 0.0;
    double hausdorff = 0.0;
    double f1 = 0.0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.3) / kDirections;
        pictures::Ellipse moved = truth;
        moved.centre.x += GetParam().distance_px * std::cos(angle);
        moved.centre.y += GetParam().distance_px * std::sin(angle);
        const Figures figures = compare(comparison(pictures::draw(160, 160, moved), true_mask));
        totals.add(figures);
        chamfer += figures.chamfer_px.value() / kDirections;
        hausdorff += figures.hausdorff95_px.value() / kDirections;
        f1 += figures.boundary_f1.value() / kDirections;
    }

    EXPECT_NEAR(totals.wrong_px / totals.edge_px, kMeanAcross * GetParam().distance_px, 0.02);
    EXPECT_NEAR(chamfer, GetParam().chamfer_px, 0.03);
    EXPECT_NEAR(hausdorff, GetParam().hausdorff95_px, 0.12);
    EXPECT_NEAR(f1, GetParam().boundary_f1, 0.015);
}

INSTANTIATE_TEST_SUITE_P(
    Shifts,
    ShiftedEllipse,
    testing::Values(
        Shift{"Sixteenth", 1.0 / 16.0, 0.035, 0.35, 1.0},
        Shift{"Quarter", 0.25, 0.17, 0.71, 1.0},
        Shift{"Half", 0.5, 0.33, 0.93, 1.0},
        Shift{"One", 1.0, 0.60, 1.21, 0.965}),
    [](const testing::TestParamInfo<Shift>& tested) { return tested.param.name; });

TEST(Floors, OfAStraightEdgeHalfAPixelOffAreReached) {
    constexpr int kTrials = 60;
    engine::Random random(5);
    Totals totals;
    double floors = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
        const pictures::StraightEdge truth = pictures::turned_edge(trial, kTrials, 64, random);
        pictures::StraightEdge moved = truth;
        const double direction =
            2.0 * std::numbers::pi * std::numbers::phi * trial; // evenly spread
        const pictures::Place step = pictures::unit(direction);
        moved.offset += 0.5 * (step.x * truth.normal.x + step.y * truth.normal.y);
        Comparison input = comparison(pictures::draw(64, 64, moved), pictures::draw(64, 64, truth));
        input.kind = pictures::round_picture(64);
        const Figures figures = compare(input);
        totals.add(figures);
        floors += figures.half_pixel_floor_px.value();
    }

    EXPECT_NEAR(totals.error_px / floors, 1.0, 0.08);
    EXPECT_NEAR(totals.error_px / totals.edge_px, 0.318, 0.025);
}

} // namespace
} // namespace measure
