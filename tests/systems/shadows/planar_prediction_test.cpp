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
        scene.casters = {caster_at("box", {0.0, 1.0, 0.0})};
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

TEST_F(PlanarPrediction, HardShadowsOfLargeLightsAreWorse) {
    wish.samples = 1;
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

TEST_F(PlanarPrediction, LargeLightsAreSampledAsOftenAsTheBudgetNeeds) {
    LightView light = lamp({0.0, 4.0, 0.0});
    light.light.radius = 0.4F;

    const auto wide = predict(light);
    ASSERT_TRUE(wide);
    EXPECT_GT(wide->variant.samples, 4);
    EXPECT_LE(wide->error_px, 1.0);

    light.light.radius = 0.005F;
    EXPECT_EQ(predict(light)->variant.samples, 1) << "its penumbra is too narrow to be seen";
}

TEST_F(PlanarPrediction, WishedSamplesAreTaken) {
    LightView light = lamp({0.0, 4.0, 0.0});
    light.light.radius = 0.2F;
    wish.samples = 9;

    const auto prediction = predict(light);

    EXPECT_EQ(prediction->variant.samples, 9);
    wish.samples = 36;
    EXPECT_LT(predict(light)->error_px, prediction->error_px);
    EXPECT_GT(predict(light)->cost.vertices, 3.9 * prediction->cost.vertices);
}

TEST_F(PlanarPrediction, PlateausServeOnlyWhereTheBudgetAllows) {
    LightView light = lamp({0.0, 4.0, 0.0});
    wish.way = "plateau";
    light.light.radius = 0.02F;
    EXPECT_EQ(predict(light)->variant, (Variant{planar_way::kPlateau, 1}));

    light.light.radius = 0.5F;
    EXPECT_GT(predict(light)->variant.samples, 1);
}

class PlanarLevels : public PlanarPrediction {
protected:
    PlanarLevels() {
        scene.casters = {caster_at("figure", {0.0, 1.0, 0.0})};
        scene.casters[0].box_deviation = {0.06, 0.01};
        box.triangles = 5000;
    }

    std::string_view way_from(double distance) {
        scene.camera.position = {0.0, 1.0, distance};
        return predict(sun({1.0F, -1.0F, 0.0F}))->variant.way;
    }
};

TEST_F(PlanarLevels, BoxesServeFromAfar) {
    EXPECT_EQ(way_from(3.0), planar_way::kGeometry);
    EXPECT_EQ(way_from(12.0), planar_way::kBoxes);
    EXPECT_EQ(way_from(60.0), planar_way::kBox);
}

TEST_F(PlanarLevels, BoxesThatAreMoreToDrawThanTheirCasterServeNothing) {
    box.triangles = 10;

    EXPECT_EQ(way_from(60.0), planar_way::kGeometry);
}

TEST_F(PlanarLevels, WishesForBoxesThatDoNotExistAreRefused) {
    scene.casters[0].box_deviation = CasterView().box_deviation;
    wish.way = "box";

    const auto refused = predict(sun());

    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("no boxes"));
}

TEST_F(PlanarLevels, KeepingPaysForManySamplesAndNotForAFew) {
    LightView light = lamp({0.0, 4.0, 0.0});
    light.light.radius = 0.4F;
    wish.samples = 64;
    EXPECT_TRUE(keeping_pays(predict(light)->cost, 20000.0));

    box.triangles = 12;
    EXPECT_FALSE(keeping_pays(predict(sun())->cost, 20000.0));
}

} // namespace
} // namespace shadows
