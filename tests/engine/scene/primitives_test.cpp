#include "engine/scene/primitives.hpp"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <ostream>

namespace scene {
namespace {

struct Solid {
    const char* name;
    Mesh mesh;
    double volume; ///< of the shape that the mesh approaches from inside
    glm::vec3 half_extent;
};

void PrintTo(const Solid& solid, std::ostream* out) {
    *out << solid.name;
}

class ClosedPrimitive : public testing::TestWithParam<Solid> {};

double signed_volume(const Mesh& mesh) {
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

TEST_P(ClosedPrimitive, IsClosedWithoutDegenerateTriangles) {
    const MeshHealth& health = GetParam().mesh.health;

    EXPECT_EQ(health.summary(), "closed");
    EXPECT_EQ(health.degenerate_triangles, 0U);
    EXPECT_EQ(health.doubled_triangles, 0U);
    EXPECT_EQ(health.remainder_triangles, 0U);
}

TEST_P(ClosedPrimitive, HoldsItsVolumeWithOutwardWinding) {
    const double volume = signed_volume(GetParam().mesh);

    EXPECT_LE(volume, GetParam().volume * (1.0 + 1e-6));
    EXPECT_GE(volume, GetParam().volume * 0.97);
}

TEST_P(ClosedPrimitive, FillsItsBounds) {
    const glm::vec3 half = GetParam().half_extent;

    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        EXPECT_NEAR(GetParam().mesh.bounds.min[axis], -half[axis], 1e-6F);
        EXPECT_NEAR(GetParam().mesh.bounds.max[axis], half[axis], 1e-6F);
    }
}

TEST_P(ClosedPrimitive, HasUnitNormalsOnTheSideOfTheWinding) {
    const Mesh& mesh = GetParam().mesh;

    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    float least = 1.0F;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        const glm::vec3 face = glm::normalize(glm::cross(
            mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 normal = mesh.normals[mesh.indices[i + k]];
            ASSERT_NEAR(glm::length(normal), 1.0F, 1e-5F);
            least = std::min(least, glm::dot(face, normal));
        }
    }
    EXPECT_GT(least, 0.98F);
}

constexpr double kPi = glm::pi<double>();

INSTANTIATE_TEST_SUITE_P(
    Shapes,
    ClosedPrimitive,
    testing::Values(
        Solid{"box", make_box({1, 2, 3}), 6.0, {0.5F, 1.0F, 1.5F}},
        Solid{"sphere", make_sphere(2.0F), 4.0 / 3.0 * kPi * 8.0, {2, 2, 2}},
        Solid{"cylinder", make_cylinder(1.0F, 3.0F), kPi * 3.0, {1.0F, 1.5F, 1.0F}},
        Solid{"cone", make_cone(1.0F, 3.0F), kPi, {1.0F, 1.5F, 1.0F}},
        Solid{"torus", make_torus(2.0F, 0.5F), 2.0 * kPi* kPi * 2.0 * 0.25, {2.5F, 0.5F, 2.5F}}),
    [](const auto& solid) { return std::string(solid.param.name); });

TEST(Primitives, APlaneIsOneOpenQuadThatFacesUp) {
    const Mesh plane = make_plane({4, 6});

    EXPECT_EQ(plane.health.open_edges, 4U);
    ASSERT_EQ(plane.patches.size(), 1U);
    EXPECT_EQ(plane.patches[0].normal, glm::vec3(0, 1, 0));
    EXPECT_FLOAT_EQ(plane.patches[0].area, 24.0F);
    EXPECT_EQ(plane.bounds.max, glm::vec3(2, 0, 3));
}

TEST(Primitives, TheCoarsestRoundShapesAreStillClosed) {
    EXPECT_TRUE(make_sphere(1.0F, 3).health.closed());
    EXPECT_TRUE(make_cylinder(1.0F, 1.0F, 3).health.closed());
    EXPECT_TRUE(make_cone(1.0F, 1.0F, 3).health.closed());
    EXPECT_TRUE(make_torus(1.0F, 0.5F, 3, 3).health.closed());
}

TEST(FinishMesh, CountsOnlyTheVerticesAndTrianglesThatSubmeshesUse) {
    Mesh mesh = make_box({2, 2, 2});
    mesh.positions.emplace_back(100.0F, 0.0F, 0.0F);
    mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
    mesh.uvs.emplace_back(0.0F, 0.0F);
    mesh.indices.insert(mesh.indices.end(), {0, 1});
    mesh.submeshes.push_back({Topology::lines, 36, 2, 0});

    finish_mesh(mesh);

    EXPECT_EQ(mesh.health.triangles, 12U);
    EXPECT_EQ(mesh.bounds.max, glm::vec3(1, 1, 1));
    EXPECT_EQ(mesh.patches.size(), 6U);
}

} // namespace
} // namespace scene
