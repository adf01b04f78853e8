// The fall-off of lights, against the formulas of KHR_lights_punctual.

#include "engine/scene/light.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

scene::PlacedLight placed(scene::LightKind kind) {
    scene::PlacedLight light;
    light.light.kind = kind;
    light.light.intensity = 100.0F;
    light.light.inner_angle = 0.3F;
    light.light.outer_angle = 0.6F;
    return light;
}

/// To the light from a point that lies `distance` away, `angle` off the light's axis (which points
/// down).
glm::vec3 to_light(float distance, float angle) {
    return distance * glm::vec3(std::sin(angle), std::cos(angle), 0.0F);
}

TEST(Light, DirectionalLightIsTheSameEverywhere) {
    const scene::PlacedLight sun = placed(scene::LightKind::directional);

    EXPECT_FLOAT_EQ(scene::illuminance_at(sun, {1.0F, 2.0F, 3.0F}), 100.0F);
    EXPECT_FLOAT_EQ(scene::illuminance_at(sun, {}), 100.0F);
}

TEST(Light, PointLightFallsWithTheSquareOfDistance) {
    const scene::PlacedLight lamp = placed(scene::LightKind::point);

    EXPECT_FLOAT_EQ(scene::illuminance_at(lamp, {0.0F, 0.0F, 5.0F}), 4.0F);
}

TEST(Light, RangeEndsTheLightSmoothly) {
    scene::PlacedLight lamp = placed(scene::LightKind::point);
    lamp.light.range = 10.0F;

    EXPECT_FLOAT_EQ(scene::illuminance_at(lamp, {5.0F, 0.0F, 0.0F}), 4.0F * (1.0F - 1.0F / 16.0F));
    EXPECT_EQ(scene::illuminance_at(lamp, {10.0F, 0.0F, 0.0F}), 0.0F);
    EXPECT_EQ(scene::illuminance_at(lamp, {11.0F, 0.0F, 0.0F}), 0.0F);
}

TEST(Light, ConeFallsFromTheInnerToTheOuterAngle) {
    const scene::PlacedLight torch = placed(scene::LightKind::spot);
    const float half_way = std::acos(0.5F * (std::cos(0.3F) + std::cos(0.6F)));

    EXPECT_NEAR(scene::illuminance_at(torch, to_light(2.0F, 0.2F)), 25.0F, 1e-3F);
    EXPECT_NEAR(scene::illuminance_at(torch, to_light(2.0F, half_way)), 25.0F * 0.25F, 1e-3F);
    EXPECT_EQ(scene::illuminance_at(torch, to_light(2.0F, 0.61F)), 0.0F);
    EXPECT_EQ(scene::illuminance_at(torch, to_light(2.0F, 3.1F)), 0.0F);
}

TEST(Light, EqualConeAnglesStayFinite) {
    scene::PlacedLight torch = placed(scene::LightKind::spot);
    torch.light.inner_angle = torch.light.outer_angle;

    EXPECT_FLOAT_EQ(scene::illuminance_at(torch, to_light(1.0F, 0.5F)), 100.0F);
    EXPECT_EQ(scene::illuminance_at(torch, to_light(1.0F, 0.7F)), 0.0F);
}

TEST(Light, APointOnTheLightIsFinite) {
    EXPECT_TRUE(std::isfinite(scene::illuminance_at(placed(scene::LightKind::point), {})));
    EXPECT_TRUE(std::isfinite(scene::illuminance_at(placed(scene::LightKind::spot), {})));
}

} // namespace
