#include "systems/shadows/volumes/swept_bounds.hpp"
#include "tests/systems/shadows/scenes.hpp"
#include "tests/systems/shadows/volumes/random_places.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

const engine::WorldAabb kFloor{{-10.0, -0.1, -10.0}, {10.0, 0.0, 10.0}};

TEST(SweptBounds, UnderASunAreTheBoxMovedAlongIt) {
    const auto reach = swept_reach(sun({1.0F, -1.0F, 0.0F}), box_at({0.0, 3.0, 0.0}, 0.5), kFloor);

    ASSERT_TRUE(reach);
    EXPECT_NEAR(reach->bounds.min.x, 2.0, 1e-5);
    EXPECT_NEAR(reach->bounds.max.x, 4.1, 1e-5);
    EXPECT_NEAR(reach->bounds.min.z, -0.5, 1e-5);
    EXPECT_NEAR(reach->bounds.max.y, 0.0, 1e-5);
}

TEST(SweptBounds, UnderALampGrowWithTheDistance) {
    const auto reach = swept_reach(lamp({0.0, 4.0, 0.0}), box_at({0.0, 2.0, 0.0}, 0.5), kFloor);

    ASSERT_TRUE(reach);
    EXPECT_NEAR(reach->bounds.max.x, 0.5 * 4.1 / 1.5, 1e-5);
    EXPECT_LT(reach->bounds.max.x, 1.5);
}

TEST(SweptBounds, NothingReachesWhatLiesBesideOrBefore) {
    EXPECT_FALSE(swept_reach(sun(), box_at({20.0, 3.0, 0.0}, 0.5), kFloor));
    EXPECT_FALSE(swept_reach(sun(), box_at({0.0, -3.0, 0.0}, 0.5), kFloor));
    EXPECT_FALSE(swept_reach(lamp({0.0, 4.0, 0.0}), box_at({0.0, -3.0, 0.0}, 0.5), kFloor));
}

TEST(SweptBounds, ALampInsideTheCasterReachesEverything) {
    const auto reach = swept_reach(lamp({0.0, 4.0, 0.0}), box_at({0.0, 4.0, 0.0}, 0.5), kFloor);

    ASSERT_TRUE(reach);
    EXPECT_EQ(reach->bounds.min, kFloor.min);
    EXPECT_EQ(reach->bounds.max, kFloor.max);
}

TEST(SweptBounds, HoldEveryPointThatIsDark) {
    engine::Random random(5);
    const scene::CameraView view = camera();
    for (int i = 0; i < 2000; ++i) {
        const engine::WorldAabb caster =
            box_at(glm::dvec3(0.0, 2.0, 0.0) + unit_vector(random) * 1.5, 0.4);
        const glm::dvec3 from = glm::dvec3(0.0, 2.0, 0.0) + unit_vector(random) * 5.0;
        const LightView light =
            i % 2 == 0 ? lamp(from) : sun(glm::vec3(glm::dvec3(0.0, 2.0, 0.0) - from));
        const glm::dvec3 on_caster =
            caster.min
            + caster.extent() * glm::dvec3(random.uniform(), random.uniform(), random.uniform());
        const glm::dvec3 way =
            i % 2 == 0 ? on_caster - light.position : glm::dvec3(light.direction);
        const glm::dvec3 dark = on_caster + way * random.uniform() * 4.0;
        const auto reach = swept_reach(light, caster, box_at(dark + glm::dvec3(0.05), 0.3));
        SCOPED_TRACE(i);

        ASSERT_TRUE(reach);
        const glm::dvec3 seen = view.project(dark);
        if (seen.z < static_cast<double>(view.near)) continue;
        if (seen.x < 0.0 || seen.y < 0.0 || seen.x > view.width || seen.y > view.height) continue;
        const PixelBox pixels = swept_pixels(view, {*reach});
        EXPECT_LE(pixels.left, seen.x);
        EXPECT_GE(pixels.right, seen.x);
        EXPECT_LE(pixels.bottom, view.height - seen.y);
        EXPECT_GE(pixels.top, view.height - seen.y);
    }
}

} // namespace
} // namespace shadows
