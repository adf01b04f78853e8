#include "systems/shadows/textures/texture_prediction.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shadows {
namespace {

class TexturePrediction : public testing::Test {
protected:
    TexturePrediction() {
        scene.camera = camera();
        scene.casters = {caster_at("box", {0.0, 1.0, 0.0})};
        floor.bounds = {{-10.0, 0.0, -10.0}, {10.0, 0.0, 10.0}};
        floor.flat = true;
        floor.normal = {0.0, 1.0, 0.0};
        scene.receivers = {floor};
        box.bounds = scene.casters[0].bounds;
        box.casters = {0};
        box.triangles = 12;
    }

    [[nodiscard]] PairView pair(const LightView& light) const {
        return {scene, light, floor, wish, budget_px};
    }
    [[nodiscard]] engine::Result<Prediction> predict(const LightView& light) const {
        return predict_texture(pair(light), box);
    }

    ShadowScene scene;
    scene::ShadowWish wish;
    double budget_px = 1.0;
    ReceiverView floor = receiver_at("floor", 1, {}, 0.0);
    CasterGroup box;
};

TEST_F(TexturePrediction, HoldsItsBudgetByItsTexels) {
    int last = kSmallestTexture;
    for (const double budget : {4.0, 1.0, 0.5, 0.25}) {
        SCOPED_TRACE(budget);
        budget_px = budget;
        EXPECT_LE(predict(sun())->error_px, budget);
        const LightView light = sun();
        EXPECT_GE(texture_layout(pair(light), box).size, last);
        last = texture_layout(pair(light), box).size;
    }
    EXPECT_GT(last, kSmallestTexture);
}

TEST_F(TexturePrediction, FarShadowsTakeSmallerTextures) {
    const LightView light = sun();
    budget_px = 0.25;
    const int near = texture_layout(pair(light), box).size;
    scene.camera.position = {0.0, 20.0, 80.0};

    EXPECT_LT(texture_layout(pair(light), box).size, near);
}

TEST_F(TexturePrediction, PointsOfALightAreTakenWhereAHardEdgeWouldBreakTheBudget) {
    LightView light = sun();
    const double hard = predict(light)->cost.taps;
    light.light.angular_radius = 0.05F;
    budget_px = 1000.0;
    EXPECT_EQ(texture_layout(pair(light), box).samples, 1);
    budget_px = 1.0;
    const TextureLayout layout = texture_layout(pair(light), box);

    EXPECT_GT(layout.samples, 1);
    EXPECT_LE(predict(light)->error_px, budget_px);
    EXPECT_GT(predict(light)->cost.taps, hard * layout.samples * 0.9);
}

TEST_F(TexturePrediction, PointsAreNoMoreThanMemoryHolds) {
    LightView light = sun();
    light.light.angular_radius = 0.05F;
    wish.samples = 1024;
    wish.map_size = 1024;

    EXPECT_EQ(texture_layout(pair(light), box).samples, 4); // 64 MiB
}

TEST_F(TexturePrediction, WhatWasAskedForIsTaken) {
    wish.map_size = 48;
    const LightView light = sun();

    EXPECT_EQ(texture_layout(pair(light), box).size, 48);
    EXPECT_GT(predict(light)->error_px, 0.04);
}

TEST_F(TexturePrediction, ALampNearItsCasterIsWorse) {
    wish.map_size = 64;

    const double far = predict(lamp({0.0, 8.0, 0.0}))->error_px;
    const double near = predict(lamp({0.0, 2.2, 0.0}))->error_px;

    EXPECT_GT(near, 1.5 * far);
}

TEST_F(TexturePrediction, ALampAmidTheCastersIsOutsideTheDomain) {
    const auto refused = predict(lamp({0.0, 1.0, 0.0}));

    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the lamp is amid the casters");
}

TEST_F(TexturePrediction, NothingIsDrawnWhereTheShadowDoesNotFall) {
    const auto prediction = predict(sun({0.0F, 1.0F, 0.0F}));

    ASSERT_TRUE(prediction);
    EXPECT_EQ(prediction->cost.draws, 0.0);
}

TEST_F(TexturePrediction, ACasterThatMayDarkenItselfIsWorse) {
    wish.map_size = 64;
    const double others = predict(sun())->error_px;
    floor.entity = scene.casters[0].id;

    EXPECT_GT(predict(sun())->error_px, others + 0.01);
    scene.casters[0].convex = true;
    EXPECT_EQ(predict(sun())->error_px, others);
}

TEST_F(TexturePrediction, AFloorThatCastsNothingMayCatchTheShadow) {
    const double free = predict(sun())->error_px;
    ReceiverView between = receiver_at("between", 2, {0.0, 0.2, 0.0}, 0.1);
    between.casts = false;
    scene.receivers.push_back(between);
    scene.everything_casts = false;

    EXPECT_GT(predict(sun())->error_px, free + 1.0);
}

TEST_F(TexturePrediction, LargeLightsAreWorse) {
    LightView light = lamp({0.0, 4.0, 0.0});
    const double hard = predict(light)->error_px;
    light.light.radius = 0.2F;

    EXPECT_GT(predict(light)->error_px, hard + 0.1);
}

/// A straight edge as a texture shows it: wrong area per length, in texels.
double edge_error(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-0.5, 0.5);
    constexpr int kSide = 8;
    const double angle = unit(random) * 6.2831853;
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    const glm::dvec2 on_edge(unit(random), unit(random));
    const auto inside = [&](const glm::dvec2& point) {
        return glm::dot(point - on_edge, normal) < 0.0;
    };
    const auto covered = [&](int x, int y) {
        double sum = 0.0;
        for (int i = 0; i < kSamplesPerSide * kSamplesPerSide; ++i) {
            const glm::dvec2 sample(i % kSamplesPerSide + 0.5, i / kSamplesPerSide + 0.5);
            sum += inside(glm::dvec2(x, y) + sample / double(kSamplesPerSide) - kSide / 2.0);
        }
        return sum / (kSamplesPerSide * kSamplesPerSide);
    };
    int wrong = 0;
    constexpr int kPoints = 100;
    for (int i = 0; i < kPoints; ++i) {
        const glm::dvec2 along(-normal.y, normal.x);
        const glm::dvec2 point = on_edge + along * 2.0 * unit(random) + normal * 2.0 * unit(random);
        const glm::dvec2 texel = point + kSide / 2.0 - 0.5;
        const glm::ivec2 first(glm::floor(texel));
        const glm::dvec2 part = texel - glm::dvec2(first);
        const auto row = [&](int y) {
            return glm::mix(covered(first.x, y), covered(first.x + 1, y), part.x);
        };
        wrong += (glm::mix(row(first.y), row(first.y + 1), part.y) >= 0.5) != inside(point);
    }
    return 2.0 * wrong / kPoints;
}

TEST(TextureEdges, HalfCoverageLiesWhereThePredictionSays) {
    std::mt19937 random(1);
    double sum = 0.0;
    constexpr int kEdges = 4000;
    for (int i = 0; i < kEdges; ++i)
        sum += edge_error(random);

    EXPECT_NEAR(sum / kEdges, 0.073, 0.005);
    EXPECT_LT(sum / kEdges, kTextureEdgeTexels);
}

} // namespace
} // namespace shadows
