#include "systems/shadows/volumes/near_clip.hpp"
#include "tests/systems/shadows/scenes.hpp"
#include "tests/systems/shadows/volumes/random_places.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

TEST(NearClip, ABoxBetweenLampAndEyeShadesTheNearPlane) {
    const scene::CameraView view = camera();
    const LightView light = lamp({0.0, 7.0, 8.0});

    EXPECT_TRUE(may_shade_near_plane(view, light, box_at({0.0, 5.0, 8.0}, 0.5)));
    EXPECT_FALSE(may_shade_near_plane(view, light, box_at({2.0, 5.0, 8.0}, 0.5)));
    EXPECT_FALSE(may_shade_near_plane(view, light, box_at({0.0, 9.0, 8.0}, 0.5)));
    EXPECT_FALSE(may_shade_near_plane(view, light, box_at({0.0, 1.0, 8.0}, 0.5)));
}

TEST(NearClip, ASunsPrismHasNoEnd) {
    const scene::CameraView view = camera();

    EXPECT_TRUE(may_shade_near_plane(view, sun(), box_at({0.0, 5000.0, 8.0}, 0.5)));
    EXPECT_FALSE(may_shade_near_plane(view, sun(), box_at({2.0, 5000.0, 8.0}, 0.5)));
    EXPECT_FALSE(may_shade_near_plane(view, sun(), box_at({0.0, 1.0, 8.0}, 0.5)));
}

TEST(NearClip, ALampInTheNearPlaneIsHeldForShading) {
    scene::CameraView view = camera();
    const glm::dvec3 beside = view.position + glm::dvec3(2.0, 0.0, -0.1);

    EXPECT_TRUE(may_shade_near_plane(view, lamp(beside), box_at({1.0, 3.0, 7.9}, 0.3)));
}

TEST(NearClip, NeverMissesABoxOnTheWayFromTheLight) {
    engine::Random random(3);
    const scene::CameraView view = camera();
    int shaded = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 from =
            view.position + unit_vector(random) * (0.5 + 6.0 * random.uniform());
        const LightView light = i % 2 == 0 ? lamp(from) : sun(glm::vec3(view.position - from));
        const glm::dvec3 on_rectangle =
            view.position
            + view.ray_direction(random.uniform() * view.width, random.uniform() * view.height)
                  * static_cast<double>(view.near);
        const glm::dvec3 toward =
            i % 2 == 0 ? from - on_rectangle : -glm::dvec3(light.direction) * 8.0;
        const glm::dvec3 between = on_rectangle + toward * random.uniform();
        const glm::dvec3 off = unit_vector(random) * 0.29;

        if (may_shade_near_plane(view, light, box_at(between + off, 0.3)))
            ++shaded;
        else
            ADD_FAILURE() << i;
    }
    EXPECT_EQ(shaded, 2000);
}

} // namespace
} // namespace shadows
