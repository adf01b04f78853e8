#include "engine/core/random.hpp"
#include "engine/scene/flat_patches.hpp"
#include "engine/scene/primitives.hpp"

#include <gtest/gtest.h>

#include <set>

namespace scene {
namespace {

/// A sheet over [0, 1] x [0, 1] in the XZ plane that faces up.
/// @param height of the vertex in column x, row z
template <class Height>
Mesh sheet(int cells, Height height) {
    Mesh mesh;
    for (int z = 0; z <= cells; ++z)
        for (int x = 0; x <= cells; ++x) {
            const glm::vec2 at = glm::vec2(x, z) / static_cast<float>(cells);
            mesh.positions.emplace_back(at.x, height(at.x, at.y), at.y);
            mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
        }
    const auto stride = static_cast<std::uint32_t>(cells) + 1;
    for (std::uint32_t z = 0; z + 1 < stride; ++z)
        for (std::uint32_t x = 0; x + 1 < stride; ++x) {
            const std::uint32_t a = z * stride + x;
            mesh.indices.insert(
                mesh.indices.end(), {a, a + stride, a + 1, a + 1, a + stride, a + stride + 1});
        }
    finish_mesh(mesh);
    return mesh;
}

/// Every triangle lies wholly in one patch, as the vertices say, and within its plane.
void expect_consistent(const Mesh& mesh) {
    const float size = glm::length(mesh.bounds.extent());
    ASSERT_EQ(mesh.patch_ids.size(), mesh.positions.size());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_LE(mesh.patches.size(), static_cast<std::size_t>(kMaxPatches));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint8_t id = mesh.patch_ids[mesh.indices[i]];
        ASSERT_EQ(mesh.patch_ids[mesh.indices[i + 1]], id);
        ASSERT_EQ(mesh.patch_ids[mesh.indices[i + 2]], id);
        ASSERT_LE(id, mesh.patches.size());
        if (id == 0) continue;
        const FlatPatch& patch = mesh.patches[id - 1];
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = mesh.positions[mesh.indices[i + k]];
            const float distance = std::abs(glm::dot(patch.normal, p) - patch.offset);
            ASSERT_LE(distance, patch.residual + 1e-6F * size);
            ASSERT_LE(patch.residual, 1e-4F * size);
            ASSERT_TRUE(patch.bounds.contains(p));
        }
    }
}

TEST(FlatPatches, ABoxHasSixOutwardSides) {
    const Mesh box = make_box({1, 2, 3});

    expect_consistent(box);
    ASSERT_EQ(box.patches.size(), 6U);
    EXPECT_FLOAT_EQ(box.patches[0].area, 6.0F);
    EXPECT_FLOAT_EQ(box.patches[5].area, 2.0F);
    for (const FlatPatch& patch : box.patches) {
        EXPECT_GT(patch.offset, 0.0F);
        EXPECT_EQ(patch.residual, 0.0F);
    }
    EXPECT_EQ(box.positions.size(), 24U);
}

TEST(FlatPatches, VerticesSharedByTwoSidesAreDuplicated) {
    const Mesh box = make_box({1, 1, 1});
    Mesh shared;
    for (int i = 0; i < 8; ++i)
        shared.positions.push_back(box.bounds.corner(i));
    shared.normals.assign(8, glm::vec3(0, 1, 0));
    shared.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    const std::vector<std::uint32_t> indices = shared.indices;
    const std::vector<glm::vec3> positions = shared.positions;

    finish_mesh(shared);

    expect_consistent(shared);
    EXPECT_TRUE(shared.health.closed());
    EXPECT_EQ(shared.health.open_edges_by_index, 0U);
    EXPECT_EQ(shared.positions.size(), 24U);
    ASSERT_EQ(shared.indices.size(), indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        EXPECT_EQ(shared.positions[shared.indices[i]], positions[indices[i]]);
}

TEST(FlatPatches, ACylinderKeepsItsCapsAndNotItsSide) {
    const Mesh cylinder = make_cylinder(1.0F, 1.0F, 96);

    expect_consistent(cylinder);
    ASSERT_EQ(cylinder.patches.size(), 2U);
    EXPECT_NEAR(std::abs(cylinder.patches[0].normal.y), 1.0F, 1e-6F);
    EXPECT_NEAR(std::abs(cylinder.patches[1].normal.y), 1.0F, 1e-6F);
}

TEST(FlatPatches, ASphereOfTinyFacetsHasNone) {
    EXPECT_TRUE(make_sphere(1.0F, 300).patches.empty());
    EXPECT_TRUE(make_torus(1.0F, 0.4F, 200, 90).patches.empty());
}

TEST(FlatPatches, AGentleBowlDoesNotDriftIntoOnePatch) {
    const Mesh bowl = sheet(60, [](float x, float z) { return 0.02F * (x * x + z * z); });

    expect_consistent(bowl);
    for (const FlatPatch& patch : bowl.patches)
        EXPECT_LT(patch.area, 0.2F);
}

TEST(FlatPatches, AFineFloorWithRoundedHeightsIsOnePatch) {
    engine::Random random(7);
    const Mesh floor =
        sheet(80, [&](float, float) { return static_cast<float>(random.uniform(-1e-5, 1e-5)); });

    expect_consistent(floor);
    ASSERT_EQ(floor.patches.size(), 1U);
    EXPECT_NEAR(floor.patches[0].area, 1.0F, 1e-3F);
    EXPECT_GT(floor.patches[0].residual, 5e-6F);
    EXPECT_GT(floor.patches[0].normal.y, 0.999F);
}

TEST(FlatPatches, AThinSlabKeepsItsTwoSidesApart) {
    const Mesh slab = make_box({10.0F, 1e-4F, 10.0F});

    expect_consistent(slab);
    ASSERT_EQ(slab.patches.size(), 2U);
    EXPECT_LT(glm::dot(slab.patches[0].normal, slab.patches[1].normal), -0.99F);
}

TEST(FlatPatches, CoplanarPartsThatDoNotTouchAreTwo) {
    Mesh mesh = make_plane({1, 1});
    const Mesh other = make_plane({1, 1});
    for (std::size_t i = 0; i < other.positions.size(); ++i) {
        mesh.positions.push_back(other.positions[i] + glm::vec3(3, 0, 0));
        mesh.normals.push_back(other.normals[i]);
        mesh.uvs.push_back(other.uvs[i]);
    }
    for (const std::uint32_t index : other.indices)
        mesh.indices.push_back(index + 4);
    mesh.submeshes.clear();

    finish_mesh(mesh);

    EXPECT_EQ(mesh.patches.size(), 2U);
}

TEST(FlatPatches, SmallSidesBelongToTheRest) {
    const Mesh post = make_box({0.1F, 10.0F, 0.1F});

    ASSERT_EQ(post.patches.size(), 4U);
    const std::set<std::uint8_t> ids(post.patch_ids.begin(), post.patch_ids.end());
    EXPECT_TRUE(ids.contains(0));
}

TEST(FlatPatches, AtMostSixteenAndTheLargestWin) {
    const Mesh prism = make_cylinder(1.0F, 40.0F, 18);

    expect_consistent(prism);
    EXPECT_EQ(prism.patches.size(), 16U);
}

TEST(FlatPatches, MeshesThatDeformHaveNone) {
    Mesh box = make_box({1, 1, 1});
    box.morph_targets.push_back({std::vector<glm::vec3>(24), {}});

    finish_mesh(box);

    EXPECT_TRUE(box.patches.empty());
    EXPECT_EQ(box.patch_ids, std::vector<std::uint8_t>(24, 0));
}

} // namespace
} // namespace scene
