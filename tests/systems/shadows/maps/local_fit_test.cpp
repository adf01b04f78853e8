#include "engine/core/random.hpp"
#include "systems/shadows/maps/local_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shadows {
namespace {

glm::dvec3 in_map(const PyramidView& view, const glm::dvec3& point) {
    const glm::dvec4 map = view.map_from_world() * glm::dvec4(point, 1.0);
    return glm::dvec3(map) / map.w;
}

LightView torch() {
    LightView light;
    light.light.kind = scene::LightKind::spot;
    light.light.outer_angle = 0.5F;
    light.position = {2.0, 5.0, -1.0};
    light.direction = glm::normalize(glm::vec3(0.3F, -1.0F, 0.2F));
    return light;
}

TEST(CubeViews, EveryDirectionIsSeenByTheFaceOfItsLargestAxisInTheCube) {
    const glm::dvec3 position(1.0, 2.0, 3.0);
    const auto views = cube_views(position, 256, 2);
    engine::Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 way(
            random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        int axis = std::abs(way.x) >= std::abs(way.y) ? 0 : 1;
        if (std::abs(way.z) > std::abs(way[axis])) axis = 2;
        const auto face = static_cast<std::size_t>(2 * axis + (way[axis] > 0.0 ? 0 : 1));
        const glm::dvec3 map = in_map(views[face], position + glm::transpose(cube_turn()) * way);
        // Two texels inside the border, so that filters find neighbours.
        EXPECT_GE(std::min(map.x, map.y), 2.0 / 256.0 - 1e-9);
        EXPECT_LE(std::max(map.x, map.y), 254.0 / 256.0 + 1e-9);
        EXPECT_NEAR(map.z, 0.001 / std::abs(way[axis]), 1e-9);
    }
}

TEST(CubeViews, ReachAsFarAsAPenumbraBeyondAQuarterTurn) {
    for (const PyramidView& view : cube_views({}, 256, 2, 0.3)) {
        const double inside = view.max.x - 2.0 * (view.max.x - view.min.x) / 256.0;
        EXPECT_NEAR(inside, 1.3, 1e-9);
    }
}

TEST(SpotView, ReachesAsFarAsAPenumbraBeyondTheCone) {
    const LightView light = torch();

    EXPECT_NEAR(
        spot_view(light, {}, 512, 0, 0.2).max.x, spot_view(light, {}, 512, 0).max.x + 0.2, 1e-9);
}

TEST(SpotView, HoldsTheConeWhereNothingSaysWhatCasts) {
    const LightView light = torch();
    const PyramidView view = spot_view(light, {}, 512, 0);
    const glm::dvec3 axis(light.direction);
    const glm::dvec3 ahead = in_map(view, light.position + axis * 4.0);
    EXPECT_NEAR(ahead.x, 0.5, 1e-6);
    EXPECT_NEAR(ahead.y, 0.5, 1e-6);
    const glm::dvec3 side = glm::transpose(view.light_from_world)[0];
    const glm::dvec3 edge = in_map(view, light.position + axis + side * std::tan(0.5));
    EXPECT_NEAR(edge.x, 1.0, 1e-6);
}

TEST(SpotView, ShrinksToWhatCasts) {
    const LightView light = torch();
    const glm::dvec3 centre = light.position + glm::dvec3(light.direction) * 4.0;
    const engine::WorldAabb box{centre - 0.2, centre + 0.2};
    const PyramidView whole = spot_view(light, {}, 512, 2);
    const PyramidView cropped = spot_view(light, {&box, 1}, 512, 2);
    EXPECT_LT(cropped.max.x - cropped.min.x, 0.3 * (whole.max.x - whole.min.x));
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 map = in_map(cropped, box.corner(i));
        EXPECT_GE(std::min(map.x, map.y), 2.0 / 512.0 - 1e-9);
        EXPECT_LE(std::max(map.x, map.y), 510.0 / 512.0 + 1e-9);
    }
}

TEST(SpotView, KeepsTheConeWhereACasterReachesRoundTheLight) {
    const LightView light = torch();
    const engine::WorldAabb round{light.position - 1.0, light.position + 1.0};
    const PyramidView whole = spot_view(light, {}, 512, 2);
    EXPECT_EQ(spot_view(light, {&round, 1}, 512, 2).max, whole.max);
}

TEST(Sees, IsFalseBehindAndBesideAndTrueInside) {
    const LightView light = torch();
    const PyramidView view = spot_view(light, {}, 512, 0);
    const auto ball = [&](double along, double aside) {
        const glm::dvec3 side = glm::transpose(view.light_from_world)[0];
        const glm::dvec3 centre =
            light.position + glm::dvec3(light.direction) * along + side * aside;
        return engine::WorldAabb{centre - 0.1, centre + 0.1};
    };
    EXPECT_TRUE(sees(view, ball(3.0, 0.0)));
    EXPECT_TRUE(sees(view, ball(3.0, 1.6)));
    EXPECT_FALSE(sees(view, ball(3.0, 3.0)));
    EXPECT_FALSE(sees(view, ball(-1.0, 0.0)));
}

} // namespace
} // namespace shadows
