#include "engine/trace/light_cone.hpp"
#include "systems/shadows/light_samples.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shadows {
namespace {

/// The part of the unit disc on one side of a line at `offset` from its middle.
double disc_before(double offset) {
    const double at = std::clamp(offset, -1.0, 1.0);
    return 0.5 + (at * std::sqrt(1.0 - at * at) + std::asin(at)) / std::numbers::pi;
}

/// Mean error of visibility per length of edge, in widths of the penumbra, over edges in all
/// directions. @param points of the unit disc
double edge_error(const std::vector<glm::dvec2>& points) {
    constexpr int kDirections = 48;
    constexpr int kSteps = 400;
    double sum = 0.0;
    for (int direction = 0; direction < kDirections; ++direction) {
        const double turn = (direction + 0.37) * 2.0 * std::numbers::pi / kDirections;
        for (int step = 0; step < kSteps; ++step) {
            const double offset = (step + 0.5) / kSteps * 2.0 - 1.0;
            double before = 0.0;
            for (const glm::dvec2& point : points)
                if (point.x * std::cos(turn) + point.y * std::sin(turn) < offset) before += 1.0;
            sum += std::abs(before / static_cast<double>(points.size()) - disc_before(offset));
        }
    }
    return sum / (kDirections * kSteps);
}

double edge_error(SamplePattern pattern, int count) {
    std::vector<glm::dvec2> points;
    for (const glm::dvec2& square : square_samples(pattern, count))
        points.push_back(disc_from_square(square));
    return edge_error(points);
}

LightView large_lamp() {
    LightView light = lamp({0.0, 4.0, 0.0});
    light.light.radius = 0.5F;
    return light;
}

class Patterns : public testing::TestWithParam<SamplePattern> {};

TEST_P(Patterns, ErrorsOfEdgesAreAsPredicted) {
    for (const int count : {4, 8, 16, 64, 128, 256}) {
        SCOPED_TRACE(count);
        const double found = edge_error(GetParam(), count);
        EXPECT_LT(found, 1.5 * sampling_error(count));
        EXPECT_GT(found, sampling_error(count) / 2.5);
    }
}

TEST_P(Patterns, EveryPointIsInItsSquareAndItsDisc) {
    for (const int count : {1, 2, 3, 7, 16, 50}) {
        SCOPED_TRACE(count);
        const auto points = square_samples(GetParam(), count);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
        for (const glm::dvec2& point : points) {
            EXPECT_GE(std::min(point.x, point.y), 0.0);
            EXPECT_LT(std::max(point.x, point.y), 1.0);
            EXPECT_LE(glm::length(disc_from_square(point)), 1.0 + 1e-12);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Patterns,
    testing::Values(SamplePattern::regular, SamplePattern::jittered, SamplePattern::hammersley));

TEST(LightSamples, TheMiddleOfTheDiscHasHalfOfTheArea) {
    int inside = 0;
    for (const glm::dvec2& square : square_samples(SamplePattern::hammersley, 4096))
        if (glm::length(disc_from_square(square)) < std::numbers::sqrt2 / 2.0) ++inside;
    EXPECT_NEAR(inside, 2048, 20);
}

TEST(LightSamples, FillTheConeThatTruthSees) {
    for (const LightView& light : {large_lamp(), [] {
                                       LightView low = sun({0.3F, -1.0F, 0.2F});
                                       low.light.angular_radius = 0.1F;
                                       return low;
                                   }()}) {
        SCOPED_TRACE(light.name);
        const glm::dvec3 point(1.0, 0.0, -2.0);
        const trace::LightCone cone(light, point);
        const double edge = glm::dot(cone.axis(), cone.direction({0.999999, 0.0}));
        const double half_of_it = glm::dot(cone.axis(), cone.direction({0.5, 0.0}));
        int inner = 0;
        for (const LightView& one : light_samples(light, point, 1024, SamplePattern::hammersley)) {
            EXPECT_FALSE(has_size(one));
            const glm::dvec3 towards = one.light.kind == scene::LightKind::directional
                                           ? -glm::dvec3(one.direction)
                                           : glm::normalize(one.position - point);
            const double cosine = glm::dot(towards, cone.axis());
            EXPECT_LE(1.0 - cosine, 1.1 * (1.0 - edge)) << "before the disc it looks wider";
            if (cosine > half_of_it) ++inner;
        }
        EXPECT_NEAR(inner, 512, 24);
    }
}

TEST(LightSamples, LieInsideTheirOutline) {
    const LightView light = large_lamp();
    engine::WorldAabb outline;
    for (const LightView& corner : light_outline(light, {2.0, 0.0, 1.0}))
        outline.grow(corner.position);
    for (const LightView& one : light_samples(light, {2.0, 0.0, 1.0}, 64, SamplePattern::jittered))
        EXPECT_TRUE(outline.contains(one.position));

    LightView low = sun({1.0F, -1.0F, 0.0F});
    low.light.angular_radius = 0.1F;
    const auto corners = light_outline(low, {});
    for (const LightView& one : light_samples(low, {}, 64, SamplePattern::jittered))
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3 side = glm::cross(
                glm::dvec3(corners[i].direction),
                glm::dvec3(corners[(i + 1) % corners.size()].direction));
            EXPECT_GE(
                glm::dot(side, glm::dvec3(one.direction))
                    * glm::dot(side, glm::dvec3(low.direction)),
                0.0);
        }
}

TEST(LightSamples, OfALampFillItsDiscFromEverySide) {
    const LightView light = large_lamp();
    const auto samples = light_samples(light, {0.0, -100.0, 0.0}, 64, SamplePattern::hammersley);
    for (const glm::dvec3& seen_along :
         {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 1.0, 0.0), glm::dvec3(0.0, 0.3, 1.0)}) {
        const glm::dvec3 axis = glm::normalize(seen_along);
        const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.1, -0.7)));
        const glm::dvec3 up = glm::cross(axis, side);
        std::vector<glm::dvec2> points;
        for (const LightView& one : samples) {
            const glm::dvec3 from = (one.position - light.position) / 0.5;
            points.emplace_back(glm::dot(from, side), glm::dot(from, up));
        }
        EXPECT_LT(edge_error(points), 2.0 * sampling_error(64));
    }
}

TEST(LightSamples, OfAPointAreThePoint) {
    const auto samples = light_samples(lamp({1.0, 2.0, 3.0}), {}, 64, SamplePattern::jittered);

    ASSERT_EQ(samples.size(), 1U);
    EXPECT_EQ(samples[0].position, glm::dvec3(1.0, 2.0, 3.0));
}

TEST(LightSamples, ALampRoundThePointStaysFinite) {
    for (const LightView& one :
         light_samples(large_lamp(), {0.0, 4.1, 0.0}, 16, SamplePattern::regular))
        EXPECT_LT(glm::length(one.position), 10.0);
}

TEST(LightSamples, WiderPenumbrasNeedMoreOfThem) {
    EXPECT_EQ(samples_for(0.0, 1.0), 1);
    EXPECT_EQ(samples_for(4.0, 1.0), 4);
    EXPECT_EQ(samples_for(20.0, 1.0), 16);
    EXPECT_EQ(samples_for(1e6, 1.0), kMostSamples);
    EXPECT_LE(sampling_error(samples_for(20.0, 1.0)) * 20.0, 1.0);
}

} // namespace
} // namespace shadows
