#include "systems/shadows/planar_projection.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

ReceiverView flat_floor(double height = 0.0) {
    ReceiverView floor = receiver_at("floor", 1, {0.0, height, 0.0}, 0.0);
    floor.bounds = {{-10.0, height, -10.0}, {10.0, height, 10.0}};
    floor.flat = true;
    floor.normal = {0.0, 1.0, 0.0};
    floor.offset = height;
    return floor;
}

constexpr glm::dvec3 kOrigin = {3.0, 1.0, -2.0};

glm::dvec3
shadow_of(const LightView& light, const ReceiverView& receiver, const glm::dvec3& point) {
    const auto plane = lit_plane(light, receiver, kOrigin);
    const glm::dvec4 shadow =
        shadow_from_caster(light, plane.value(), kOrigin) * glm::dvec4(point - kOrigin, 1.0);
    return kOrigin + glm::dvec3(shadow) / shadow.w;
}

void expect_at(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-9);
    EXPECT_NEAR(found.y, expected.y, 1e-9);
    EXPECT_NEAR(found.z, expected.z, 1e-9);
}

TEST(PlanarProjection, ASunMovesPointsAlongItsRays) {
    expect_at(shadow_of(sun({1.0F, -1.0F, 0.0F}), flat_floor(), {0.5, 2.0, 3.0}), {2.5, 0.0, 3.0});
}

TEST(PlanarProjection, ALampSpreadsPointsByTheirHeight) {
    expect_at(shadow_of(lamp({0.0, 4.0, 0.0}), flat_floor(), {1.0, 2.0, -0.5}), {2.0, 0.0, -1.0});
}

TEST(PlanarProjection, PointsOnThePlaneStayWhereTheyAre) {
    expect_at(
        shadow_of(lamp({2.0, 5.0, 1.0}), flat_floor(1.5), {-3.0, 1.5, 4.0}), {-3.0, 1.5, 4.0});
}

TEST(PlanarProjection, EveryShadowLiesOnAPlaneAtAnySlant) {
    ReceiverView slope = flat_floor();
    slope.normal = glm::normalize(glm::dvec3(0.3, 1.0, -0.2));
    slope.offset = 0.7;
    for (const LightView& light : {sun({0.2F, -1.0F, 0.5F}), lamp({1.0, 6.0, 2.0})})
        EXPECT_NEAR(
            glm::dot(slope.normal, shadow_of(light, slope, {0.4, 2.0, -1.0})), slope.offset, 1e-9);
}

/// By similar triangles the shadow of v on a plane through the origin across an axis lies, along
/// another axis, at (l_y v_x - l_x v_y) / (l_y - v_y).
TEST(PlanarProjection, OnAxisPlanesItIsTheRuleOfSimilarTriangles) {
    const glm::dvec3 light(3.0, 5.0, 4.0);
    const glm::dvec3 point(-0.5, 1.5, 0.7);
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        ReceiverView wall = flat_floor();
        wall.normal = glm::dvec3(0.0);
        wall.normal[axis] = 1.0;
        glm::dvec3 expected(0.0);
        for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
            expected[other] = (light[axis] * point[other] - light[other] * point[axis])
                              / (light[axis] - point[axis]);

        expect_at(shadow_of(lamp(light), wall, point), expected);
    }
}

TEST(PlanarProjection, PointsBeyondTheLightGetANegativeWeight) {
    const LightView light = lamp({0.0, 2.0, 0.0});
    const auto plane = lit_plane(light, flat_floor(), kOrigin);
    const glm::dvec3 beyond(1.0, 3.0, 0.0);

    const glm::dvec4 shadow =
        shadow_from_caster(light, *plane, kOrigin) * glm::dvec4(beyond - kOrigin, 1.0);

    EXPECT_LT(shadow.w, 0.0);
    EXPECT_GT(plane->height(beyond), plane->most_height());
}

TEST(PlanarProjection, ThereIsNoLitPlaneWithTheLightBehindIt) {
    EXPECT_FALSE(lit_plane(sun({0.0F, 1.0F, 0.0F}), flat_floor(), kOrigin));
    EXPECT_FALSE(lit_plane(lamp({0.0, -1.0, 0.0}), flat_floor(), kOrigin));
    EXPECT_FALSE(lit_plane(lamp({0.0, 0.0, 0.0}), flat_floor(), kOrigin));
}

TEST(PlanarProjection, ReceiversSeenFromBehindAreLitFromBehind) {
    ReceiverView curtain = flat_floor();
    curtain.two_sided = true;

    const auto plane = lit_plane(lamp({0.0, -1.0, 0.0}), curtain, kOrigin);

    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->normal, glm::dvec3(0.0, -1.0, 0.0));
    EXPECT_DOUBLE_EQ(plane->light_height, 1.0);
}

TEST(PlanarProjection, UnevenReceiversKeepTheirBumpsOutOfTheirShadow) {
    ReceiverView bumpy = flat_floor();
    bumpy.residual = 0.01;

    const auto plane = lit_plane(sun(), bumpy, kOrigin);

    EXPECT_GT(plane->least_height, bumpy.residual);
}

class ShadowBounds : public testing::Test {
protected:
    static engine::WorldAabb bounds(const LightView& light, const engine::WorldAabb& caster) {
        const ReceiverView floor = flat_floor();
        return shadow_bounds(light, lit_plane(light, floor, {}).value(), floor, caster);
    }
};

TEST_F(ShadowBounds, HoldTheShadowAndLittleElse) {
    const engine::WorldAabb found = bounds(sun({1.0F, -1.0F, 0.0F}), box_at({0.0, 2.0, 0.0}, 0.5));

    EXPECT_NEAR(found.min.x, 1.0, 1e-3);
    EXPECT_NEAR(found.max.x, 3.0, 1e-3);
    EXPECT_NEAR(found.max.z, 0.5, 1e-3);
}

TEST_F(ShadowBounds, AreEmptyForWhatLiesUnderThePlane) {
    EXPECT_TRUE(bounds(sun(), box_at({0.0, -2.0, 0.0}, 0.5)).empty());
}

TEST_F(ShadowBounds, AreEmptyForWhatLiesBeyondTheLight) {
    EXPECT_TRUE(bounds(lamp({0.0, 2.0, 0.0}), box_at({1.0, 3.0, 0.0}, 0.5)).empty());
}

TEST_F(ShadowBounds, AreEmptyForShadowsThatMissTheReceiver) {
    EXPECT_TRUE(bounds(sun({1.0F, -0.1F, 0.0F}), box_at({0.0, 2.0, 0.0}, 0.5)).empty());
}

TEST_F(ShadowBounds, HoldTheWholeReceiverForWhatStraddlesTheLight) {
    const engine::WorldAabb found = bounds(lamp({0.0, 2.0, 0.0}), box_at({1.0, 2.0, 0.0}, 0.5));

    EXPECT_LE(found.min.x, -10.0);
    EXPECT_GE(found.max.x, 10.0);
}

TEST_F(ShadowBounds, HoldTheFootOfWhatStandsInTheFloor) {
    const engine::WorldAabb found = bounds(sun({1.0F, -1.0F, 0.0F}), box_at({0.0, 0.0, 0.0}, 0.5));

    EXPECT_LE(found.min.x, -0.5);
    EXPECT_GE(found.max.x, 1.0);
}

} // namespace
} // namespace shadows
