#include "engine/scene/box_set.hpp"
#include "engine/scene/primitives.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace scene {
namespace {

/// Every corner of every triangle lies in a box.
void expect_held(const Mesh& mesh, const BoxSet& set) {
    for (const std::uint32_t index : mesh.indices) {
        bool held = false;
        for (const engine::Aabb& box : set.boxes)
            held = held || box.contains(mesh.positions[index]);
        ASSERT_TRUE(held);
    }
}

TEST(BoxSets, HoldTheirMesh) {
    const Mesh torus = make_torus(1.0F, 0.2F);

    ASSERT_EQ(torus.box_sets.size(), 2U);
    EXPECT_EQ(torus.box_sets[0].boxes.size(), 1U);
    EXPECT_EQ(torus.box_sets[1].boxes.size(), 8U);
    for (const BoxSet& set : torus.box_sets)
        expect_held(torus, set);
}

TEST(BoxSets, KnowHowFarABoxIsFromABall) {
    const Mesh ball = make_sphere(1.0F, 64);

    // The corners between a square of side 2 and its circle, over the square's outline as the
    // cells see it: its true length times pi / 4.
    const double expected = (4.0 - std::numbers::pi) / (8.0 * std::numbers::pi / 4.0);
    ASSERT_EQ(ball.box_sets.size(), 2U);
    EXPECT_NEAR(static_cast<double>(ball.box_sets[0].deviation), expected, 0.02);
}

TEST(BoxSets, AHoleThatIsFilledDoesNotVanishInTheMean) {
    // A frame with bars at right angles: the mean over all outlines is small, the holes are not.
    Mesh grate;
    constexpr int kBars = 9;
    constexpr float kSpacing = 0.25F;
    for (int i = 0; i < kBars; ++i) {
        const float place = kSpacing * static_cast<float>(i);
        test_support::add_part(grate, make_box({2.05F, 0.05F, 0.05F}), {1.0F, 0.0F, place});
        test_support::add_part(grate, make_box({0.05F, 0.05F, 2.05F}), {place, 0.0F, 1.0F});
    }

    const auto sets = make_box_sets(grate.positions, grate.indices);

    // The middle of a hole is half a hole away from the bars, a cell is 2.05 / 64.
    constexpr double kHalfHole = 0.5 * (0.25 - 0.05);
    ASSERT_EQ(sets.size(), 2U);
    EXPECT_GT(static_cast<double>(sets[0].deviation), 0.25 * (kHalfHole - 0.04));
}

TEST(BoxSets, SeveralAreNearerThanOne) {
    const Mesh torus = make_torus(1.0F, 0.2F);

    EXPECT_LT(torus.box_sets[1].deviation, 0.7F * torus.box_sets[0].deviation);
}

TEST(BoxSets, OfWhatIsABoxAreNotNeeded) {
    EXPECT_TRUE(make_box(glm::vec3(1.0F)).box_sets.empty());
}

TEST(BoxSets, OfASplitBoxAreExact) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1, (i & 2) / 2, (i & 4) / 4);
    std::vector<std::uint32_t> triangles;
    for (int times = 0; times < 2; ++times)
        for (const std::uint32_t index : {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                          2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5})
            triangles.push_back(static_cast<std::uint32_t>(index));

    const auto sets = make_box_sets(corners, triangles);

    ASSERT_EQ(sets.size(), 1U);
    EXPECT_EQ(sets[0].deviation, 0.0F);
}

TEST(BoxSets, FlatMeshesHaveFiniteDeviations) {
    const Mesh plane = make_plane(glm::vec2(2.0F));
    for (const BoxSet& set : make_box_sets(plane.positions, plane.indices))
        EXPECT_TRUE(std::isfinite(set.deviation));
}

} // namespace
} // namespace scene
