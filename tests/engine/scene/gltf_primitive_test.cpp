// Primitive modes and normals.

#include "engine/scene/gltf_primitive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using testing::ElementsAre;

struct ModeCase {
    const char* name;
    int mode;
    std::vector<std::uint32_t> indices;
    scene::Topology topology;
    std::vector<std::uint32_t> expected;
};

class PrimitiveMode : public testing::TestWithParam<ModeCase> {};

TEST_P(PrimitiveMode, BecomesAList) {
    const auto list = scene::list_indices(GetParam().mode, GetParam().indices);

    ASSERT_TRUE(list);
    EXPECT_EQ(list->topology, GetParam().topology);
    EXPECT_EQ(list->indices, GetParam().expected);
}

using scene::Topology;

INSTANTIATE_TEST_SUITE_P(
    Gltf,
    PrimitiveMode,
    testing::Values(
        ModeCase{"points", 0, {4, 5}, Topology::points, {4, 5}},
        ModeCase{"lines", 1, {4, 5, 6, 7}, Topology::lines, {4, 5, 6, 7}},
        ModeCase{"lines_with_a_rest", 1, {4, 5, 6}, Topology::lines, {4, 5}},
        ModeCase{"line_loop", 2, {4, 5, 6}, Topology::lines, {4, 5, 5, 6, 6, 4}},
        ModeCase{"line_loop_of_two", 2, {4, 5}, Topology::lines, {4, 5}},
        ModeCase{"line_strip", 3, {4, 5, 6}, Topology::lines, {4, 5, 5, 6}},
        ModeCase{"line_strip_of_one", 3, {4}, Topology::lines, {}},
        ModeCase{"triangles", 4, {4, 5, 6}, Topology::triangles, {4, 5, 6}},
        ModeCase{"triangles_with_a_rest", 4, {4, 5, 6, 7, 8}, Topology::triangles, {4, 5, 6}},
        ModeCase{
            "triangle_strip", 5, {4, 5, 6, 7, 8}, Topology::triangles, {4, 5, 6, 5, 7, 6, 6, 7, 8}},
        ModeCase{"triangle_strip_of_two", 5, {4, 5}, Topology::triangles, {}},
        ModeCase{"triangle_fan", 6, {4, 5, 6, 7}, Topology::triangles, {5, 6, 4, 6, 7, 4}},
        ModeCase{"empty_fan", 6, {}, Topology::triangles, {}}),
    [](const auto& test) { return test.param.name; });

TEST(PrimitiveModes, OthersAreRefused) {
    EXPECT_FALSE(scene::list_indices(7, {0, 1, 2}));
    EXPECT_FALSE(scene::list_indices(-1, {0, 1, 2}));
}

/// Two triangles that share an edge: one in the plane z = 0, one in the plane x = 0.
scene::PrimitiveData folded() {
    scene::PrimitiveData data;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    data.indices = {0, 1, 2, 0, 2, 3};
    return data;
}

TEST(MakeFlat, GivesEveryTriangleItsOwnVerticesAndNormal) {
    scene::PrimitiveData data = folded();
    data.uvs = {{0, 0}, {1, 0}, {0, 1}, {5, 5}};

    scene::make_flat(data);

    EXPECT_THAT(data.indices, ElementsAre(0, 1, 2, 3, 4, 5));
    ASSERT_EQ(data.normals.size(), 6U);
    EXPECT_EQ(data.normals[2], glm::vec3(0, 0, 1));
    EXPECT_EQ(data.normals[3], glm::vec3(1, 0, 0));
    EXPECT_EQ(data.positions[5], glm::vec3(0, 0, 1));
    EXPECT_EQ(data.uvs[5], glm::vec2(5, 5));
}

TEST(MakeFlat, NormalsFollowMorphTargets) {
    scene::PrimitiveData data = folded();
    data.indices = {0, 1, 2};
    data.morph_targets.push_back(
        {{{0, 0, 0}, {0, 0, 0}, {0, -1, 1}, {0, 0, 0}}, {}}); // turns it into the plane y = 0

    scene::make_flat(data);

    EXPECT_EQ(data.normals[0] + data.morph_targets[0].normal_deltas[0], glm::vec3(0, -1, 0));
}

TEST(MakeFlat, TrianglesWithoutAreaStillGetAUnitNormal) {
    scene::PrimitiveData data = folded();
    data.indices = {1, 1, 2};

    scene::make_flat(data);

    EXPECT_EQ(glm::length(data.normals[0]), 1.0F);
}

TEST(MendNormals, ReplacesThoseWithoutDirection) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    scene::PrimitiveData data = folded();
    data.normals = {{0, 0, 0}, {0, 0, 1}, {none, 0, 0}, {7, 0, 0}};

    EXPECT_EQ(scene::mend_normals(data), 3U);

    const float half = std::sqrt(0.5F);
    EXPECT_NEAR(glm::distance(data.normals[0], {half, 0, half}), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::distance(data.normals[2], {half, 0, half}), 0.0F, 1e-6F);
    EXPECT_EQ(data.normals[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(data.normals[3], glm::vec3(1, 0, 0));
}

TEST(MendNormals, QuantisedNormalsAreScaledWithoutAWord) {
    scene::PrimitiveData data = folded();
    data.normals.assign(4, {0.0F, 0.99F, 0.0F});

    EXPECT_EQ(scene::mend_normals(data), 0U);
    EXPECT_EQ(data.normals[0], glm::vec3(0, 1, 0));
}

} // namespace
