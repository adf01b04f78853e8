#include "engine/scene/primitives.hpp"
#include "systems/shadows/volumes/shadow_volume.hpp"
#include "tests/systems/shadows/volumes/random_places.hpp"
#include "tests/systems/shadows/volumes/volume_counting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shadows {
namespace {

using testing::IsEmpty;

constexpr glm::dvec4 kLamp{0.3, 3.1, 0.2, 1.0};
constexpr glm::dvec4 kSun{0.31, 0.9, 0.17, 0.0};

ShadowVolume volume_of(const scene::Mesh& mesh, const glm::dvec4& light, bool surrounded = false) {
    ShadowVolume volume;
    VolumeBuilder().build(make_caster_surface(mesh), mesh.positions, light, surrounded, volume);
    return volume;
}

int count_at(
    const glm::dvec3& point,
    const scene::Mesh& mesh,
    const glm::dvec4& light,
    bool surrounded = false) {
    return volumes_round(
        point, {0.123, 0.0456, 0.987}, volume_of(mesh, light, surrounded), mesh.positions, light);
}

scene::Mesh flipped(scene::Mesh mesh, std::size_t every) {
    for (std::size_t t = 0; 3 * t < mesh.indices.size(); t += every)
        std::swap(mesh.indices[3 * t], mesh.indices[3 * t + 1]);
    return mesh;
}

scene::Mesh box() {
    return scene::make_box(glm::vec3(1.0F));
}

TEST(ShadowVolume, OfABoxHoldsWhatLiesBehindItOnce) {
    EXPECT_EQ(count_at({0.0, -3.0, 0.01}, box(), kLamp), 1);
    EXPECT_EQ(count_at({0.0, -300.0, 0.01}, box(), kLamp), 1);
    EXPECT_EQ(count_at({0.0, 1.0, 0.01}, box(), kLamp), 0);
    EXPECT_EQ(count_at({3.0, -3.0, 0.01}, box(), kLamp), 0);
}

TEST(ShadowVolume, OfASunGoesAlongItsWay) {
    const glm::dvec3 along = -glm::dvec3(kSun);

    EXPECT_EQ(count_at(along * 5.0, box(), kSun), 1);
    EXPECT_EQ(count_at(-along * 5.0, box(), kSun), 0);
    EXPECT_EQ(count_at({0.0, -5.0, 0.01}, box(), kSun), 0);
}

TEST(ShadowVolume, OfASheetCountsOneWhicheverSideIsLit) {
    const scene::Mesh plane = scene::make_plane({2.0F, 2.0F});

    EXPECT_EQ(count_at({0.1, -1.0, 0.01}, plane, kLamp), 1);
    EXPECT_EQ(count_at({0.1, 1.0, 0.01}, plane, {0.3, -3.1, 0.2, 1.0}), 1);
    EXPECT_EQ(count_at({0.1, 1.0, 0.01}, plane, kLamp), 0);
}

TEST(ShadowVolume, RoundALampInsideABoxHoldsEverythingOutside) {
    const glm::dvec4 inside(0.1, 0.1, -0.05, 1.0);

    EXPECT_GT(count_at({0.0, -3.0, 0.01}, box(), inside, true), 0);
    EXPECT_GT(count_at({0.0, 3.0, 0.01}, box(), inside, true), 0);
    EXPECT_EQ(count_at({0.1, -0.3, 0.01}, box(), inside, true), 0);
}

TEST(ShadowVolume, IsTheSameHoweverTrianglesAreWound) {
    const scene::Mesh ball = scene::make_sphere(0.7F, 12);
    for (const std::size_t every : {1U, 3U, 10U}) {
        SCOPED_TRACE(every);
        const scene::Mesh turned = flipped(ball, every);

        EXPECT_EQ(count_at({0.0, -3.0, 0.01}, turned, kLamp), 1);
        EXPECT_EQ(count_at({0.0, 1.0, 0.01}, turned, kLamp), 0);
        EXPECT_EQ(count_at({4.0, -3.0, 0.01}, turned, kLamp), 0);
    }
}

/// Meshes of every kind of health.
std::vector<std::pair<std::string, scene::Mesh>> meshes() {
    scene::Mesh soup = scene::make_sphere(0.7F, 10);
    soup.indices.resize(soup.indices.size() / 2 / 3 * 3); // half a ball
    soup.submeshes[0].index_count = static_cast<std::uint32_t>(soup.indices.size());
    return {
        {"box", box()},
        {"ball", scene::make_sphere(0.7F, 16)},
        {"torus", scene::make_torus(0.6F, 0.2F, 16, 8)},
        {"plane", scene::make_plane({1.0F, 1.0F})},
        {"badly wound", flipped(scene::make_sphere(0.7F, 12), 7)},
        {"half a ball", soup},
        {"badly wound half", flipped(soup, 4)}};
}

TEST(ShadowVolume, HasNoRim) {
    engine::Random random(7);
    for (const auto& [name, mesh] : meshes()) {
        const auto same_place = scene::weld_by_position(mesh.positions);
        for (int i = 0; i < 40; ++i) {
            const bool sun = i % 2 == 0;
            const glm::dvec3 at = unit_vector(random) * 3.0;
            SCOPED_TRACE(fmt::format("{} {}", name, i));

            const ShadowVolume volume = volume_of(mesh, {at, sun ? 0.0 : 1.0}, i % 3 == 0);

            EXPECT_THAT(unmatched_edges(volume, same_place, sun), IsEmpty());
        }
    }
}

TEST(ShadowVolume, HasNoRimWhereTheLightLiesInAFacesPlane) {
    const scene::Mesh mesh = box();
    const auto same_place = scene::weld_by_position(mesh.positions);
    for (const double x : {-1e-7, 0.0, 1e-7}) {
        const glm::dvec4 light(0.5 + x, 3.0, 0.5, 1.0);

        EXPECT_THAT(unmatched_edges(volume_of(mesh, light), same_place, false), IsEmpty());
    }
}

TEST(ShadowVolume, CountsWhatARayFromTheLightPasses) {
    engine::Random random(11);
    for (const auto& [name, mesh] : meshes())
        for (int i = 0; i < 40; ++i) {
            const glm::dvec4 light(unit_vector(random) * 3.0, 1.0);
            const glm::dvec3 point = unit_vector(random) * 2.5;
            SCOPED_TRACE(fmt::format("{} {}", name, i));
            int passed = 0;
            for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
                const auto corner = [&](std::size_t k) {
                    return glm::dvec3(mesh.positions[mesh.indices[t + k]]) - glm::dvec3(light);
                };
                const glm::dvec3 way = point - glm::dvec3(light);
                const double volume = glm::dot(corner(0), glm::cross(corner(1), corner(2)));
                const double u = glm::dot(way, glm::cross(corner(1), corner(2))) / volume;
                const double v = glm::dot(way, glm::cross(corner(2), corner(0))) / volume;
                const double w = glm::dot(way, glm::cross(corner(0), corner(1))) / volume;
                if (u > 0.0 && v > 0.0 && w > 0.0 && u + v + w > 1.0) ++passed;
            }

            EXPECT_EQ(count_at(point, mesh, light, true), passed);
            EXPECT_EQ(count_at(point, mesh, light) > 0, passed > 0);
        }
}

TEST(ShadowVolume, KeepsTheOrderOfCornersInItsCaps) {
    const scene::Mesh plane = scene::make_plane({1.0F, 1.0F});
    const ShadowVolume lit = volume_of(plane, kLamp);
    const ShadowVolume unlit = volume_of(plane, {0.3, -3.1, 0.2, 1.0});

    ASSERT_EQ(lit.near_end - lit.side_end, 6U);
    ASSERT_EQ(unlit.indices.size() - unlit.near_end, 6U);
    for (std::uint32_t i = 0; i < 6; ++i) {
        EXPECT_EQ(lit.indices[lit.side_end + i], 2 * plane.indices[i]);
        EXPECT_EQ(unlit.indices[unlit.near_end + i], 2 * plane.indices[i]);
    }
}

} // namespace
} // namespace shadows
