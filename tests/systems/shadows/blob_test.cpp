#include "systems/shadows/blob_fit.hpp"
#include "systems/shadows/blob_prediction.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shadows {
namespace {

CasterView plank(const glm::vec3& half = {2.0F, 0.05F, 0.25F}) {
    CasterView caster = caster_at("plank", {0.0, 1.0, 0.0});
    caster.bounds_mesh = {-half, half};
    caster.world_from_mesh = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 1.0, 0.0));
    caster.bounds = engine::transformed(caster.world_from_mesh, caster.bounds_mesh);
    return caster;
}

TEST(BlobFit, TouchesTheSidesOfTheCastersBox) {
    const Blob blob = fit_blob(plank());

    for (const glm::dvec3 side :
         {glm::dvec3(2, 0, 0), glm::dvec3(0, 0.05, 0), glm::dvec3(0, 0, 0.25)})
        EXPECT_NEAR(glm::length(blob.unit_from_world * side), 1.0, 1e-6);
    EXPECT_EQ(blob.centre, glm::dvec3(0.0, 1.0, 0.0));
}

TEST(BlobFit, TurnsWithItsCaster) {
    CasterView turned = plank();
    turned.world_from_mesh =
        turned.world_from_mesh
        * glm::rotate(glm::dmat4(1.0), std::numbers::pi / 2.0, glm::dvec3(0.0, 1.0, 0.0));

    const Blob blob = fit_blob(turned);

    EXPECT_NEAR(glm::length(blob.unit_from_world * glm::dvec3(0, 0, 2)), 1.0, 1e-6);
}

TEST(BlobFit, SheetsGetALittleThickness) {
    const Blob blob = fit_blob(plank({2.0F, 0.0F, 0.25F}));

    EXPECT_TRUE(std::isfinite(glm::determinant(blob.unit_from_world)));
    EXPECT_GT(glm::length(blob.unit_from_world * glm::dvec3(0, 0.01, 0)), 1.0);
}

TEST(BlobFit, PointsWithoutSizeAreStillFinite) {
    EXPECT_TRUE(std::isfinite(glm::determinant(fit_blob(plank(glm::vec3(0.0F))).unit_from_world)));
}

TEST(BlobFit, ItsDiscIsAsLargeAsItsEllipse) {
    const Blob blob = fit_blob(plank());

    EXPECT_NEAR(disc_radius(blob, sun()), std::sqrt(2.0 * 0.25), 1e-6);
    EXPECT_NEAR(disc_radius(round_blob(blob, sun()), sun()), std::sqrt(2.0 * 0.25), 1e-6);
}

TEST(BlobFit, SweepsAlongTheSun) {
    const engine::WorldAabb floor{{-10.0, 0.0, -10.0}, {10.0, 0.0, 10.0}};

    const engine::WorldAabb swept =
        swept_bounds(sun({1.0F, -1.0F, 0.0F}), box_at({0.0, 2.0, 0.0}, 0.5), floor);

    EXPECT_LE(swept.min.x, 1.0);
    EXPECT_GE(swept.max.x, 3.0);
    EXPECT_GT(swept.min.x, 0.0);
    EXPECT_LT(swept.max.x, 4.5);
}

TEST(BlobFit, SweepsAwayFromLamps) {
    const engine::WorldAabb wall{{-10.0, -10.0, -5.1}, {10.0, 10.0, -5.0}};

    const engine::WorldAabb swept = swept_bounds(lamp({}), box_at({0.0, 0.0, -1.0}, 0.2), wall);

    EXPECT_GE(swept.max.x, 1.25); // (0.2 / 0.8) x 5 of the near side
    EXPECT_LT(swept.max.x, 10.1);
}

TEST(BlobFit, SweepsNothingTowardsTheLight) {
    const engine::WorldAabb ceiling{{-10.0, 5.0, -10.0}, {10.0, 5.1, 10.0}};

    EXPECT_TRUE(swept_bounds(sun(), box_at({0.0, 2.0, 0.0}, 0.5), ceiling).empty());
}

class BlobPrediction : public testing::Test {
protected:
    static engine::Result<Prediction>
    predict_under(const LightView& light, double half, double distance) {
        ShadowScene scene;
        scene.camera = camera();
        scene.camera.position = {0.0, 3.0, distance};
        ReceiverView floor = receiver_at("floor", 1, {}, 0.0);
        floor.bounds = {{-100.0, 0.0, -100.0}, {100.0, 0.0, 100.0}};
        CasterGroup group;
        group.casters = {0};
        group.bounds = box_at({0.0, 2.0, 0.0}, half);
        group.largest_radius = half * std::sqrt(3.0);
        scene.casters.resize(1);
        scene.casters[0].bounds = group.bounds;
        const scene::ShadowWish wish;
        return predict_blob({scene, light, floor, wish, 1.0}, group);
    }
    static Prediction predict(double half, double distance) {
        return *predict_under(sun(), half, distance);
    }
};

TEST_F(BlobPrediction, ErrsLessTheSmallerTheCaster) {
    EXPECT_LT(predict(0.1, 20.0).error_px, predict(0.2, 20.0).error_px);
    EXPECT_LT(predict(0.2, 20.0).error_px, predict(0.8, 20.0).error_px);
}

TEST_F(BlobPrediction, ErrsLessTheFartherTheCaster) {
    EXPECT_LT(predict(0.5, 80.0).error_px, predict(0.5, 40.0).error_px);
    EXPECT_LT(predict(0.5, 40.0).error_px, predict(0.5, 10.0).error_px);
}

TEST_F(BlobPrediction, IsInsideABudgetOfOnePixelForAFewPixelsOnly) {
    EXPECT_GT(predict(0.5, 10.0).error_px, 1.0);
    EXPECT_LT(predict(0.05, 20.0).error_px, 1.0);
}

TEST_F(BlobPrediction, ALampBesideItsCasterIsOutOfTheDomain) {
    LightView lamp = sun();
    lamp.light.kind = scene::LightKind::point;
    lamp.position = {0.0, 2.3, 0.0};

    const auto refused = predict_under(lamp, 0.2, 20.0);

    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the lamp is as near to '' as that is large");
    lamp.position = {0.0, 2.5, 0.0};
    EXPECT_TRUE(predict_under(lamp, 0.2, 20.0));
}

} // namespace
} // namespace shadows
