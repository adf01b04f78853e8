#include "engine/trace/trace_scene.hpp"
#include "tests/engine/trace/small_world.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trace {
namespace {

constexpr glm::dvec3 kDown = {0, -1, 0};
constexpr glm::dvec3 kUp = {0, 1, 0};

TEST(TraceScene, AnEmptyWorldBuildsNothingAndStopsNothing) {
    const scene::World world;
    TraceScene scene(world);

    EXPECT_FALSE(scene.intersect({0, 5, 0}, kDown).has_value());
    EXPECT_FALSE(scene.occluded(glm::dvec3(0, 5, 0), kDown, 10.0));
    EXPECT_EQ(scene.build_count(), 0U);
    EXPECT_TRUE(scene.bounds().empty());
}

TEST(TraceScene, AHitSaysWhatWhereAndHowFar) {
    SmallWorld small;
    small.add(scene::make_sphere(1.0F), {10, 0, 0});
    const ecs::Entity box = small.add(scene::make_box({2, 4, 6}), {0, 1, 0});
    const TraceScene scene(small.world);

    const auto hit = scene.intersect({0.25, 13, 0.5}, 2.0 * kDown);

    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->entity, box);
    EXPECT_DOUBLE_EQ(hit->t, 5.0);
    EXPECT_DOUBLE_EQ(hit->position.y, 3.0);
    EXPECT_EQ(hit->normal, kUp);
    const scene::Mesh& mesh = small.world.assets.meshes[1];
    EXPECT_EQ(mesh.patches[hit->patch_id - 1U].normal, glm::vec3(0, 1, 0));
    glm::dvec3 from_corners(0.0);
    for (int k = 0; k < 3; ++k)
        from_corners +=
            hit->barycentrics[k]
            * glm::dvec3(
                mesh.positions[mesh.indices[hit->triangle + static_cast<std::uint32_t>(k)]]);
    EXPECT_NEAR(glm::distance(from_corners + glm::dvec3(0, 1, 0), hit->position), 0.0, 1e-12);
}

TEST(TraceScene, NothingIsHitBeyondTheLimit) {
    SmallWorld small;
    small.add(scene::make_box({2, 2, 2}));
    const TraceScene scene(small.world);

    EXPECT_TRUE(scene.intersect({0, 5, 0}, kDown, 4.001).has_value());
    EXPECT_FALSE(scene.intersect({0, 5, 0}, kDown, 3.999).has_value());
    EXPECT_TRUE(scene.occluded(glm::dvec3(0, 5, 0), 7.0 * kDown, 4.001));
    EXPECT_FALSE(scene.occluded(glm::dvec3(0, 5, 0), 7.0 * kDown, 3.999));
}

TEST(TraceScene, BackFacesAreInvisibleButBlockLight) {
    SmallWorld small;
    small.add(scene::make_plane({4, 4}));
    const TraceScene scene(small.world);
    Surface below;
    below.position = {0.5, -1, 0.25};

    EXPECT_TRUE(scene.intersect({0.5, 1, 0.25}, kDown).has_value());
    EXPECT_FALSE(scene.intersect({0.5, -1, 0.25}, kUp).has_value());
    EXPECT_TRUE(scene.occluded(below, kUp));
}

TEST(TraceScene, DoubleSidedMaterialsAreSeenFromBothSides) {
    SmallWorld small;
    small.world.assets.materials[0].double_sided = true;
    small.add(scene::make_plane({4, 4}));
    const TraceScene scene(small.world);

    const auto hit = scene.intersect({0.5, -1, 0.25}, kUp);

    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->normal, kDown);
}

TEST(TraceScene, MirroredInstancesKeepTheirOutside) {
    SmallWorld small;
    const std::uint32_t mesh = small.add_mesh(scene::make_sphere(1.0F, 32));
    small.add(mesh, glm::scale(glm::dmat4(1.0), {-2, 1, 3}));
    const TraceScene scene(small.world);

    const auto from_outside = scene.intersect({0.1, 5, 0.2}, kDown);
    const auto from_inside = scene.intersect({0.1, 0, 0.2}, kDown);

    ASSERT_TRUE(from_outside.has_value());
    EXPECT_GT(from_outside->position.y, 0.9);
    EXPECT_GT(from_outside->normal.y, 0.9);
    EXPECT_FALSE(from_inside.has_value());
}

TEST(TraceScene, EntitiesThatDoNotCastAreSeenButNeverBlock) {
    SmallWorld small;
    const ecs::Entity box = small.add(scene::make_box({2, 2, 2}));
    small.world.registry.patch<scene::ShadowRole>(
        box, [](scene::ShadowRole& role) { role.casts = false; });
    TraceScene scene(small.world);
    Surface below;
    below.position = {0, -3, 0};

    EXPECT_TRUE(scene.intersect({0, 5, 0}, kDown).has_value());
    EXPECT_FALSE(scene.occluded(below, kUp));
    EXPECT_TRUE(scene.occluded(below.position, kUp, 5.0));

    small.world.registry.patch<scene::ShadowRole>(
        box, [](scene::ShadowRole& role) { role.casts = true; });
    scene.update(small.world);

    EXPECT_TRUE(scene.occluded(below, kUp));
    EXPECT_EQ(scene.build_count(), 1U);
}

TEST(TraceScene, AShadowRayIsNotStoppedByTheTriangleItStartsFrom) {
    SmallWorld small;
    small.add(scene::make_plane({4, 4}));
    const TraceScene scene(small.world);
    const auto hit = scene.intersect({0.5, 1, 0.25}, kDown);
    ASSERT_TRUE(hit.has_value());

    EXPECT_FALSE(scene.occluded(*hit, kUp, kInfinity, 0.0));
    Surface stranger = *hit;
    stranger.triangle = kNoTriangle;
    EXPECT_TRUE(scene.occluded(stranger, kUp, kInfinity, 0.0));
}

TEST(TraceScene, UpdateBuildsOnlyWhatChanged) {
    SmallWorld small;
    const ecs::Entity still = small.add(scene::make_box({1, 1, 1}));
    const ecs::Entity mover = small.add(scene::make_box({1, 1, 1}), {5, 0, 0});
    TraceScene scene(small.world);
    ASSERT_EQ(scene.build_count(), 2U);

    scene.update(small.world);
    EXPECT_EQ(scene.build_count(), 2U);

    small.world.registry.patch<scene::WorldTransform>(
        mover, [](auto& transform) { transform.world_from_local[3].x = 3.0; });
    scene.update(small.world);
    EXPECT_EQ(scene.build_count(), 3U);
    EXPECT_TRUE(scene.intersect({3, 5, 0}, kDown).has_value());
    EXPECT_FALSE(scene.intersect({5, 5, 0}, kDown).has_value());

    small.world.registry.destroy(still);
    scene.update(small.world);
    EXPECT_EQ(scene.build_count(), 3U);
    EXPECT_FALSE(scene.intersect({0, 5, 0}, kDown).has_value());
    EXPECT_EQ(scene.triangle_count(), 12U);

    small.add(scene::make_box({1, 1, 1}), {-3, 0, 0});
    scene.update(small.world);
    EXPECT_TRUE(scene.intersect({-3, 5, 0}, kDown).has_value());
}

TEST(TraceScene, PosedVerticesAreWhatIsHit) {
    SmallWorld small;
    const ecs::Entity box = small.add(scene::make_box({1, 1, 1}));
    scene::PosedMesh posed;
    for (const glm::vec3& p : small.world.assets.meshes[0].positions) {
        posed.positions.push_back(p + glm::vec3(0, 2, 0));
        posed.bounds.grow(posed.positions.back());
    }
    small.world.registry.add<scene::PosedMesh>(box, posed);
    TraceScene scene(small.world);
    EXPECT_DOUBLE_EQ(scene.intersect({0.1, 5, 0.2}, kDown)->position.y, 2.5);

    small.world.registry.patch<scene::PosedMesh>(box, [](scene::PosedMesh& pose) {
        for (glm::vec3& p : pose.positions)
            p.y += 1.0F;
        pose.bounds.max.y += 1.0F;
    });
    scene.update(small.world);

    EXPECT_DOUBLE_EQ(scene.intersect({0.1, 5, 0.2}, kDown)->position.y, 3.5);
}

TEST(TraceScene, FollowsAWorldThatMovesFarAway) {
    SmallWorld small;
    const ecs::Entity box = small.add(scene::make_box({1, 1, 1}));
    TraceScene scene(small.world);
    const glm::dvec3 far = {1e5 + 0.0625, 0, -2e5};

    small.world.registry.patch<scene::WorldTransform>(
        box, [&](auto& transform) { transform.world_from_local[3] = glm::dvec4(far, 1.0); });
    scene.update(small.world);

    const auto hit = scene.intersect(far + glm::dvec3(0.499, 5, 0.499), kDown);
    ASSERT_TRUE(hit.has_value());
    EXPECT_DOUBLE_EQ(hit->t, 4.5);
    EXPECT_FALSE(scene.intersect(far + glm::dvec3(0.501, 5, 0.499), kDown).has_value());
}

TEST(TraceScene, ARayFromFarOutsideHitsTheSamePlace) {
    SmallWorld small;
    small.add(scene::make_box({1, 1, 1}));
    const TraceScene scene(small.world);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-1, -1, -1));

    const auto hit = scene.intersect(glm::dvec3(0.5, 0.3, 0.1) - 1e8 * direction, direction);

    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(glm::distance(hit->position, glm::dvec3(0.5, 0.3, 0.1)), 0.0, 1e-6);
}

TEST(TraceScene, NoRaySlipsBetweenNeighbours) {
    SmallWorld small;
    const std::uint32_t mesh = small.add_mesh(scene::make_sphere(1.0F, 24));
    glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.3, glm::normalize(glm::dvec3(1, 2, 3)));
    turned[3] = {100.3, -7.7, 55.1, 1.0};
    small.add(mesh, turned);
    const TraceScene scene(small.world);
    const std::vector<glm::vec3>& positions = small.world.assets.meshes[mesh].positions;
    int lost = 0;

    // Straight at vertices and at points of edges, where rounding is most tempted.
    for (std::size_t i = 0; i + 1 < positions.size(); ++i)
        for (const double along : {0.0, 0.25, 0.5}) {
            const glm::dvec3 local =
                glm::mix(glm::dvec3(positions[i]), glm::dvec3(positions[i + 1]), along);
            const glm::dvec3 target = turned * glm::dvec4(local, 1.0);
            const glm::dvec3 outward = target - glm::dvec3(turned[3]);
            Surface start;
            start.position = target + 3.0 * outward;
            if (!scene.occluded(start, -outward)) ++lost;
        }

    EXPECT_EQ(lost, 0);
}

TEST(TraceScene, EqualDistancesGoToTheLowerEntity) {
    SmallWorld small;
    const std::uint32_t mesh = small.add_mesh(scene::make_box({1, 1, 1}));
    const ecs::Entity first = small.add(mesh);
    const ecs::Entity second = small.add(mesh);
    TraceScene scene(small.world);
    EXPECT_EQ(scene.intersect({0.1, 5, 0.2}, kDown)->entity, first);

    small.world.registry.patch<scene::WorldTransform>(first, [](auto& /*same*/) {});
    scene.update(small.world);

    EXPECT_EQ(scene.intersect({0.1, 5, 0.2}, kDown)->entity, first);
    EXPECT_NE(first, second);
}

TEST(TraceScene, LinesAndEmptyTrianglesAreNotThere) {
    SmallWorld small;
    scene::Mesh mesh = scene::make_plane({2, 2});
    mesh.indices.insert(mesh.indices.end(), {0, 0, 1, 0, 1});
    mesh.submeshes = {{scene::Topology::triangles, 0, 9, 0}, {scene::Topology::lines, 9, 2, 0}};
    scene::finish_mesh(mesh);
    small.add(std::move(mesh));

    const TraceScene scene(small.world);

    EXPECT_EQ(scene.triangle_count(), 2U);
}

} // namespace
} // namespace trace
