#include "systems/shadows/volumes/volume_prediction.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shadows {
namespace {

using testing::HasSubstr;

struct VolumePrediction : testing::Test {
    ShadowScene scene = box_over_floor();
    scene::ShadowWish wish;

    engine::Result<Prediction> predict() {
        const auto groups = group_casters(scene, scene.lights[0]);
        return predict_volume(
            {scene, scene.lights[0], scene.receivers[0], wish, 1.0}, groups.front());
    }
};

TEST_F(VolumePrediction, AHardLightsEdgesAreOffByThePrecisionFloor) {
    const auto predicted = predict();

    ASSERT_TRUE(predicted);
    EXPECT_NEAR(predicted->error_px, 0.04, 1e-9);
    EXPECT_GT(predicted->cost.stencil_fragments, 0.0);
}

TEST_F(VolumePrediction, ALargeLightsEdgesAreTooHard) {
    scene.lights[0].light.angular_radius = 0.05F;

    EXPECT_GT(predict()->error_px, 0.3);
}

TEST_F(VolumePrediction, RefusesHolesThatATextureCuts) {
    scene.casters[0].alpha_masked = true;

    const auto predicted = predict();

    ASSERT_FALSE(predicted);
    EXPECT_THAT(predicted.error().message, HasSubstr("'box' has holes"));
}

TEST_F(VolumePrediction, RefusesADriverWhoseStencilDoesNotWrap) {
    scene.wraps_stencil = false;

    EXPECT_FALSE(predict());
}

TEST_F(VolumePrediction, ACasterBetweenLightAndEyeCostsItsCaps) {
    scene.casters[0].triangles = 10000;
    const double clear = predict()->cost.vertices;
    scene.camera.position = {0.0, 0.2, 0.0};

    EXPECT_GT(predict()->cost.vertices, clear + 5000.0);
}

TEST_F(VolumePrediction, AnOpenCasterCostsMoreThanAClosedOne) {
    const double open = predict()->cost.vertices;
    scene.casters[0].closed = true;

    EXPECT_LT(predict()->cost.vertices, open);
}

} // namespace
} // namespace shadows
