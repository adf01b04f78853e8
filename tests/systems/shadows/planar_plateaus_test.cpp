#include "engine/scene/primitives.hpp"
#include "systems/shadows/light_samples.hpp"
#include "systems/shadows/planar_plateaus.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

ReceiverView flat_floor() {
    ReceiverView floor = receiver_at("floor", 1, {}, 0.0);
    floor.bounds = {{-10.0, 0.0, -10.0}, {10.0, 0.0, 10.0}};
    floor.flat = true;
    floor.normal = {0.0, 1.0, 0.0};
    return floor;
}

LightView with_size(LightView light) {
    light.light.radius = 0.05F;
    light.light.angular_radius = 0.01F;
    return light;
}

glm::dvec3 shadow_of(const LightView& light, const glm::dvec3& point) {
    const auto plane = lit_plane(light, flat_floor(), {});
    const glm::dvec4 shadow = shadow_from_caster(light, *plane, {}) * glm::dvec4(point, 1.0);
    return glm::dvec3(shadow) / shadow.w;
}

class Ellipses : public testing::TestWithParam<LightView> {};

TEST_P(Ellipses, HoldTheShadowsThatThePointsOfTheLightThrow) {
    const LightView& light = GetParam();
    const LitPlane plane = lit_plane(light, flat_floor(), {}).value();
    const glm::dvec3 point(0.6, 1.5, -0.3);
    const PenumbraEllipse ellipse = penumbra_ellipse(light, plane, point);
    const double a = glm::dot(ellipse.radius_0, ellipse.radius_0);
    const double b = glm::dot(ellipse.radius_0, ellipse.radius_1);
    const double c = glm::dot(ellipse.radius_1, ellipse.radius_1);
    double widest = 0.0;
    for (const LightView& one :
         light_samples(light, ellipse.centre, 256, SamplePattern::hammersley)) {
        const glm::dvec3 from = shadow_of(one, point) - ellipse.centre;
        const double along_0 = glm::dot(from, ellipse.radius_0);
        const double along_1 = glm::dot(from, ellipse.radius_1);
        const glm::dvec2 in_circle =
            glm::dvec2(c * along_0 - b * along_1, a * along_1 - b * along_0) / (a * c - b * b);
        widest = std::max(widest, glm::length(in_circle));
    }
    EXPECT_NEAR(widest, 1.0, 0.08);
}

INSTANTIATE_TEST_SUITE_P(
    Lights,
    Ellipses,
    testing::Values(
        with_size(sun({0.0F, -1.0F, 0.0F})),
        with_size(sun({1.0F, -0.6F, 0.3F})),
        with_size(lamp({0.5, 4.0, 0.2})),
        with_size(lamp({-2.0, 3.0, 1.0}))),
    [](const auto& tested) { return std::to_string(tested.index); });

std::vector<PlateauEdge> edges_of(const scene::Mesh& mesh, double height) {
    const LightView light = with_size(lamp({0.0, 4.0, 0.0}));
    return plateau_edges(
        light,
        lit_plane(light, flat_floor(), {}).value(),
        make_caster_surface(mesh),
        mesh.positions,
        glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, height, 0.0)),
        {});
}

TEST(Plateaus, ABoxUnderTheLightHasTheOutlineOfItsTop) {
    EXPECT_EQ(edges_of(scene::make_box(glm::vec3(1.0F)), 2.0).size(), 4U);
}

TEST(Plateaus, OutlinesUnderTheFloorAreLeftOut) {
    EXPECT_TRUE(edges_of(scene::make_box(glm::vec3(1.0F)), -2.0).empty());
}

TEST(Plateaus, SlopesStandBesideTheirEdge) {
    for (const PlateauEdge& edge : edges_of(scene::make_box(glm::vec3(1.0F)), 2.0)) {
        const glm::dvec3 along = edge.to - edge.from;
        // A lamp of radius 0.05 at 4 m over a corner 2.5 m high: 0.05 * 2.5 / 1.5.
        EXPECT_NEAR(glm::length(edge.side_from), 0.083, 0.01);
        EXPECT_NEAR(glm::dot(glm::normalize(along), edge.side_from), 0.0, 0.02);
    }
}

} // namespace
} // namespace shadows
