#include "engine/scene/mesh_health.hpp"
#include "engine/scene/primitives.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace scene {
namespace {

using Corners = std::vector<std::uint32_t>;

/// A unit tetrahedron, wound outward.
const std::vector<glm::vec3> kTetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Corners kTetrahedronCorners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

TEST(WeldByPosition, MapsEqualPositionsToTheFirst) {
    const std::vector<glm::vec3> positions = {{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0F, 0, -0.0F}};

    EXPECT_EQ(weld_by_position(positions), (Corners{0, 1, 0, 1}));
}

TEST(WeldByPosition, KeepsNeighbouringFloatsApart) {
    const std::vector<glm::vec3> positions = {{1, 0, 0}, {std::nextafter(1.0F, 2.0F), 0, 0}};

    EXPECT_EQ(weld_by_position(positions), (Corners{0, 1}));
}

TEST(MeshHealth, ATetrahedronIsClosed) {
    const MeshHealth health = examine_mesh(kTetrahedron, kTetrahedronCorners);

    EXPECT_TRUE(health.closed());
    EXPECT_TRUE(health.convex);
    EXPECT_EQ(health.summary(), "closed");
    EXPECT_EQ(health.triangles, 4U);
    EXPECT_EQ(health.open_edges_by_index, 0U);
    EXPECT_EQ(health.remainder_triangles, 0U);
}

TEST(MeshHealth, AMissingTriangleLeavesThreeOpenEdges) {
    const Corners corners(kTetrahedronCorners.begin(), kTetrahedronCorners.end() - 3);

    const MeshHealth health = examine_mesh(kTetrahedron, corners);

    EXPECT_EQ(health.open_edges, 3U);
    EXPECT_FALSE(health.closed());
    EXPECT_EQ(health.summary(), "open (3 edges)");
}

TEST(MeshHealth, ATurnedTriangleFlipsItsThreeEdges) {
    Corners corners = kTetrahedronCorners;
    std::swap(corners[10], corners[11]);

    const MeshHealth health = examine_mesh(kTetrahedron, corners);

    EXPECT_EQ(health.flipped_edges, 3U);
    EXPECT_EQ(health.open_edges, 0U);
    EXPECT_FALSE(health.closed());
    EXPECT_EQ(health.remainder_triangles, 1U);
    EXPECT_EQ(health.summary(), "badly wound (3 edges)");
}

TEST(MeshHealth, AFinOnAnEdgeIsNonManifoldAndItsFaceIsTheRemainder) {
    std::vector<glm::vec3> positions = kTetrahedron;
    positions.emplace_back(1.0F, -1.0F, -1.0F);
    Corners corners = kTetrahedronCorners;
    corners.insert(corners.end(), {0, 1, 4});
    testing::internal::CaptureStderr();

    const MeshHealth health = examine_mesh(positions, corners);

    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(health.non_manifold_edges, 1U);
    EXPECT_EQ(health.open_edges, 2U);
    EXPECT_EQ(health.remainder_triangles, 1U);
    EXPECT_EQ(health.summary(), "open (2 edges), non-manifold (1 edge)");
}

TEST(MeshHealth, DegenerateTrianglesAreCountedAndOtherwiseIgnored) {
    std::vector<glm::vec3> positions = kTetrahedron;
    positions.emplace_back(0.0F, 0.0F, 0.0F); // welds to 0
    Corners corners = kTetrahedronCorners;
    corners.insert(corners.end(), {1, 1, 2, 0, 4, 2});

    const MeshHealth health = examine_mesh(positions, corners);

    EXPECT_EQ(health.triangles, 6U);
    EXPECT_EQ(health.degenerate_triangles, 2U);
    EXPECT_TRUE(health.closed());
}

TEST(MeshHealth, ATriangleWithoutWidthClosesTheEdgeThatItMends) {
    std::vector<glm::vec3> positions = kTetrahedron;
    positions.emplace_back(
        0.5F, 0.0F, 0.0F); // on the edge from 0 to 1, known to one of its faces only
    const Corners mended = {0, 2, 4, 4, 2, 1, 0, 4, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

    EXPECT_TRUE(examine_mesh(positions, mended).closed());
}

TEST(MeshHealth, DoubledTrianglesAreFoundWhicheverWayTheyAreWound) {
    Corners corners = kTetrahedronCorners;
    corners.insert(corners.end(), {2, 1, 0, 0, 1, 2});

    const MeshHealth health = examine_mesh(kTetrahedron, corners);

    EXPECT_EQ(health.doubled_triangles, 2U);
    EXPECT_EQ(health.non_manifold_edges, 3U);
}

TEST(MeshHealth, ABoxIsClosedOnlyAfterTheWeld) {
    const MeshHealth health = make_box({1, 2, 3}).health;

    EXPECT_EQ(health.open_edges_by_index, 24U);
    EXPECT_TRUE(health.closed());
}

TEST(MeshHealth, ABoxShowsSixEdgesOnAverageAndAnOutlineOfAQuarterOfItsSides) {
    const MeshHealth health = make_box({1, 2, 3}).health;

    // Four edges along each axis, each in the silhouette from half of all directions.
    EXPECT_NEAR(health.outline_edges, 6.0, 1e-6);
    EXPECT_NEAR(health.outline, 4.0 * (1.0 + 2.0 + 3.0) * 0.5 * std::numbers::pi / 4.0, 1e-6);
}

TEST(MeshHealth, ABallsOutlineIsACircle) {
    EXPECT_NEAR(make_sphere(2.0F, 64).health.outline, 2.0 * std::numbers::pi * 2.0, 0.05);
}

TEST(MeshHealth, TheRimOfASheetIsAlwaysInItsOutline) {
    const MeshHealth health = make_plane({1, 1}).health;

    EXPECT_NEAR(health.outline_edges, 4.0, 1e-6);
    EXPECT_NEAR(health.outline, std::numbers::pi, 1e-6);
}

TEST(MeshHealth, NothingIsNotClosed) {
    const MeshHealth health = examine_mesh({}, {});

    EXPECT_FALSE(health.closed());
    EXPECT_EQ(health.summary(), "empty");
}

} // namespace
} // namespace scene
