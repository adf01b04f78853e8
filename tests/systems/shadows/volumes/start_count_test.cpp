#include "engine/scene/primitives.hpp"
#include "systems/shadows/volumes/near_clip.hpp"
#include "systems/shadows/volumes/start_count.hpp"
#include "tests/support/worlds.hpp"
#include "tests/systems/shadows/volumes/random_places.hpp"
#include "tests/systems/shadows/volumes/volume_counting.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

using test_support::camera_looking;

/// A ring, turned and moved, and a light in its mesh space.
struct StartCount : testing::Test {
    scene::Mesh mesh = scene::make_torus(1.0F, 0.35F, 24, 12);
    glm::dmat4 world_from_mesh = glm::rotate(
        glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, 1.5, -0.2)),
        0.6,
        glm::normalize(glm::dvec3(1.0, 0.3, 0.2)));
    ShadowVolume volume;

    std::optional<int> at(const scene::CameraView& camera, const glm::dvec4& light_mesh) {
        VolumeBuilder().build(make_caster_surface(mesh), mesh.positions, light_mesh, false, volume);
        return start_count(
            camera,
            volume,
            mesh.positions,
            world_from_mesh,
            light_mesh,
            engine::transformed(world_from_mesh, mesh.bounds));
    }
};

TEST_F(StartCount, IsWhatHoldsEveryPlaceOfTheNearRectangle) {
    engine::Random random(17);
    int known = 0;
    int shaded = 0;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        const glm::dvec4 light(unit_vector(random) * 4.0, i % 2 == 0 ? 0.0 : 1.0);
        const glm::dvec3 away =
            glm::normalize(glm::dvec3(world_from_mesh * glm::dvec4(-glm::dvec3(light), 0.0)));
        const glm::dvec3 eye = glm::dvec3(world_from_mesh[3]) + away * random.uniform(1.5, 4.0)
                               + unit_vector(random) * 0.8;
        const scene::CameraView camera = camera_looking(eye, eye + unit_vector(random), 64, 64);

        const std::optional<int> count = at(camera, light);

        if (!count) continue;
        ++known;
        shaded += *count > 0 ? 1 : 0;
        const auto corners = near_rectangle(camera);
        for (const auto& [u, v] :
             {std::pair(0.01, 0.02), std::pair(0.98, 0.03), std::pair(0.47, 0.97)}) {
            const glm::dvec3 place = camera.position + corners[0] + (corners[1] - corners[0]) * u
                                     + (corners[3] - corners[0]) * v;
            const glm::dvec3 place_mesh(glm::inverse(world_from_mesh) * glm::dvec4(place, 1.0));
            EXPECT_EQ(
                volumes_round(place_mesh, {0.123, 0.0456, 0.987}, volume, mesh.positions, light),
                *count);
        }
    }
    EXPECT_GT(known, 250);
    EXPECT_GT(shaded, 80);
}

TEST_F(StartCount, IsUnknownWhereAnOutlineCutsTheRectangle) {
    world_from_mesh = glm::dmat4(1.0);
    mesh = scene::make_box(glm::vec3(1.0F));
    scene::CameraView camera = camera_looking({0.5, -2.0, 0.0}, {0.5, -4.0, -5.0}, 64, 64);

    EXPECT_FALSE(at(camera, {0.0, 1.0, 0.0, 0.0}));
    camera.position.x = 0.3;
    EXPECT_EQ(at(camera, {0.0, 1.0, 0.0, 0.0}), 1);
    camera.position.x = 0.7;
    EXPECT_EQ(at(camera, {0.0, 1.0, 0.0, 0.0}), 0);
}

TEST_F(StartCount, IsUnknownInsideTheCaster) {
    const glm::dvec3 middle(world_from_mesh[3]);

    EXPECT_FALSE(at(camera_looking(middle, {9.0, 0.0, 0.0}, 64, 64), {0.0, 1.0, 0.0, 0.0}));
}

} // namespace
} // namespace shadows
