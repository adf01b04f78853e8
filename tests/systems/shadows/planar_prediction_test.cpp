#include "systems/shadows/planar_prediction.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shadows {
namespace {

class PlanarPrediction : public testing::Test {
protected:
    PlanarPrediction() {
        scene.camera = camera();
        floor.bounds = {{-10.0, 0.0, -10.0}, {10.0, 0.0, 10.0}};
        floor.flat = true;
        floor.normal = {0.0, 1.0, 0.0};
        box.bounds = box_at({0.0, 1.0, 0.0}, 0.5);
        box.casters = {0};
        box.triangles = 12;
    }

    engine::Result<Prediction> predict(const LightView& light) {
        return predict_planar({scene, light, floor, wish, 1.0}, box);
    }

    ShadowScene scene;
    scene::ShadowWish wish;
    ReceiverView floor = receiver_at("floor", 1, {}, 0.0);
    CasterGroup box;
};

TEST_F(PlanarPrediction, HardLightsOnPlanesAreExact) {
    EXPECT_NEAR(predict(sun({1.0F, -1.0F, 0.0F}))->error_px, 0.04, 1e-6);
    EXPECT_NEAR(predict(lamp({0.0, 4.0, 0.0}))->error_px, 0.04, 1e-6);
}

TEST_F(PlanarPrediction, RefusesReceiversThatAreNotFlat) {
    floor.flat = false;

    const auto refused = predict(sun());

    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the receiver is not flat");
}

TEST_F(PlanarPrediction, RefusesGrazingSunsAndSaysHowLowTheyAre) {
    const auto refused = predict(sun({1.0F, -0.005F, 0.0F}));

    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("0.29 degrees"));
}

TEST_F(PlanarPrediction, NothingIsDrawnWhereNoLightFalls) {
    const auto prediction = predict(sun({0.0F, 1.0F, 0.0F}));

    ASSERT_TRUE(prediction);
    EXPECT_EQ(prediction->cost.draws, 0.0);
    EXPECT_EQ(prediction->error_px, 0.0);
}

TEST_F(PlanarPrediction, UnevenReceiversAreWorseTheLowerTheSun) {
    floor.residual = 0.01;

    const double high = predict(sun({0.2F, -1.0F, 0.0F}))->error_px;
    const double low = predict(sun({3.0F, -1.0F, 0.0F}))->error_px;

    EXPECT_GT(high, 0.04);
    EXPECT_GT(low, 4.0 * high);
}

TEST_F(PlanarPrediction, LargeLightsAreWorse) {
    double last = 0.0;
    for (const float radius : {0.0F, 0.05F, 0.1F, 0.4F}) {
        SCOPED_TRACE(radius);
        LightView light = lamp({0.0, 4.0, 0.0});
        light.light.radius = radius;
        const double error = predict(light)->error_px;
        EXPECT_GT(error, last);
        last = error;
    }
}

TEST_F(PlanarPrediction, ShadowsFarAwayCostLess) {
    const double near = predict(sun())->cost.stencil_fragments;
    scene.camera.position = {0.0, 3.0, 40.0};

    EXPECT_LT(predict(sun())->cost.stencil_fragments, 0.2 * near);
}

} // namespace
} // namespace shadows
