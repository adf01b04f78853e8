// Real models as they come, where a folder of them is at hand: GNOMON_ASSETS, or shared/assets
// beside the project. Counts are those of an independent script (exact positions, all primitives of
// a mesh joined).

#include "engine/scene/gltf.hpp"
#include "engine/scene/world.hpp"
#include "tests/support/assets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

using test_support::assets_folder;

struct AssetCase {
    const char* name;
    const char* file;
    std::uint32_t triangles;
    std::uint32_t open_edges_by_index;
    std::uint32_t open_edges;
    std::uint32_t non_manifold_edges;
    std::uint32_t flipped_edges;
    std::uint32_t degenerate_triangles;
    std::size_t closed_meshes;
    std::size_t meshes;
};

class Asset : public testing::TestWithParam<AssetCase> {};

void expect_sound(const scene::World& world) {
    world.registry.each<scene::PosedMesh>(
        [](ecs::Entity /*entity*/, const scene::PosedMesh& posed) {
            for (const glm::vec3& position : posed.positions)
                ASSERT_TRUE(std::isfinite(glm::length(position)));
        });
    EXPECT_FALSE(scene::world_bounds(world).empty());
}

TEST_P(Asset, LoadsWithTheHealthThatWasCounted) {
    const AssetCase& expected = GetParam();
    const std::filesystem::path file = assets_folder() / expected.file;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;

    auto model = scene::load_gltf(file);

    ASSERT_TRUE(model) << engine::to_string(model.error());
    scene::MeshHealth sum;
    std::size_t closed = 0;
    for (const scene::Mesh& mesh : model->meshes) {
        sum.triangles += mesh.health.triangles;
        sum.open_edges_by_index += mesh.health.open_edges_by_index;
        sum.open_edges += mesh.health.open_edges;
        sum.non_manifold_edges += mesh.health.non_manifold_edges;
        sum.flipped_edges += mesh.health.flipped_edges;
        sum.degenerate_triangles += mesh.health.degenerate_triangles;
        closed += mesh.health.closed() ? 1U : 0U;
    }
    EXPECT_EQ(sum.triangles, expected.triangles);
    EXPECT_EQ(sum.open_edges_by_index, expected.open_edges_by_index);
    EXPECT_EQ(sum.open_edges, expected.open_edges);
    EXPECT_EQ(sum.non_manifold_edges, expected.non_manifold_edges);
    EXPECT_EQ(sum.flipped_edges, expected.flipped_edges);
    EXPECT_EQ(sum.degenerate_triangles, expected.degenerate_triangles);
    EXPECT_EQ(closed, expected.closed_meshes);
    EXPECT_EQ(model->meshes.size(), expected.meshes);

    scene::World world;
    scene::instantiate(world, scene::add_assets(world.assets, std::move(*model)), "");
    scene::update(world, 0.0F);
    scene::update(world, 0.3F);
    expect_sound(world);
}

INSTANTIATE_TEST_SUITE_P(
    Gltf,
    Asset,
    testing::Values(
        AssetCase{"torusknot", "torusknot/torusknot.gltf", 2880, 264, 0, 0, 0, 0, 1, 1},
        AssetCase{"primitives", "primitives/primitives.gltf", 3636, 1804, 0, 0, 0, 0, 6, 6},
        AssetCase{"room", "room/room.glb", 63720, 5480, 0, 0, 0, 0, 17, 17},
        AssetCase{
            "chair",
            "monobloc_chair/plastic_monobloc_chair_01_1k.gltf",
            3356,
            2870,
            0,
            0,
            0,
            0,
            1,
            1},
        AssetCase{"fox", "fox/Fox.glb", 576, 1728, 0, 0, 0, 0, 1, 1},
        AssetCase{"cesium_man", "cesium_man/CesiumMan.glb", 4672, 1894, 0, 0, 0, 0, 1, 1},
        AssetCase{"knight", "knight/Knight.glb", 6952, 6186, 278, 0, 0, 0, 4, 15},
        AssetCase{"morph_cube", "morph_cube/AnimatedMorphCube.gltf", 12, 24, 0, 0, 0, 0, 1, 1},
        AssetCase{"milk_truck", "milk_truck/CesiumMilkTruck.gltf", 2856, 2690, 8, 0, 0, 0, 1, 2},
        AssetCase{"rock", "rocks/rock.gltf", 180, 184, 0, 0, 0, 0, 1, 1},
        AssetCase{"rocks", "rocks/rocks_1000.gltf", 180, 184, 0, 0, 0, 0, 1, 1},
        AssetCase{"terrain", "terrain/terrain.gltf", 5202, 10404, 204, 0, 0, 0, 0, 1},
        AssetCase{"terrain_4km", "terrain/terrain_4km.gltf", 5202, 10404, 204, 0, 0, 0, 0, 1},
        AssetCase{"two_sided_plane", "two_sided_plane/TwoSidedPlane.gltf", 2, 6, 4, 0, 0, 0, 0, 1},
        AssetCase{"tree", "tree/scene.gltf", 778, 1068, 512, 0, 0, 0, 0, 2},
        AssetCase{"tree_mask", "tree/scene_mask.gltf", 778, 1068, 512, 0, 0, 0, 0, 2},
        AssetCase{
            "dutch_ship",
            "dutch_ship/dutch_ship_medium_1k.gltf",
            69162,
            47530,
            12234,
            19,
            44,
            0,
            0,
            3},
        AssetCase{"teapot", "teapot/teapot.gltf", 9128, 288, 258, 0, 0, 8, 0, 1},
        AssetCase{
            "flight_helmet", "flight_helmet/FlightHelmet.gltf", 94722, 15826, 296, 0, 0, 0, 3, 6},
        AssetCase{"zdm2", "zdm2/zdm2.glb", 58772, 87822, 13981, 3050, 14, 2, 0, 1},
        AssetCase{"living_room", "living_room/living_room.glb", 5088, 3821, 86, 88, 5, 3520, 0, 2}),
    [](const auto& test) { return test.param.name; });

engine::Result<scene::Model> broken(const char* file) {
    return scene::load_gltf(assets_folder() / "broken" / file);
}

struct BrokenCase {
    const char* file;
    const char* message;
};

class BrokenAsset : public testing::TestWithParam<BrokenCase> {};

TEST_P(BrokenAsset, IsRefusedByName) {
    if (!std::filesystem::exists(assets_folder())) GTEST_SKIP() << "no " << assets_folder();

    const auto model = broken(GetParam().file);

    ASSERT_FALSE(model);
    EXPECT_THAT(model.error().message, testing::HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Gltf,
    BrokenAsset,
    testing::Values(
        BrokenCase{"BoxWithInfinites.glb", "is not finite"},
        BrokenCase{"IndexOutOfRange.gltf", "is past its 24 vertices"},
        BrokenCase{"AllIndicesOutOfRange.gltf", "is past its 24 vertices"},
        BrokenCase{"RecursiveNodes.gltf", "is its own ancestor"}));

TEST(BrokenAssets, BadNormalsAreMended) {
    if (!std::filesystem::exists(assets_folder())) GTEST_SKIP() << "no " << assets_folder();

    const auto model = broken("BoxBadNormals.glb");

    ASSERT_TRUE(model) << engine::to_string(model.error());
    EXPECT_THAT(
        model->warnings, testing::Contains(testing::HasSubstr("normals were not of length 1")));
    EXPECT_TRUE(model->meshes.at(0).health.closed());
    for (const glm::vec3& normal : model->meshes[0].normals)
        EXPECT_NEAR(glm::length(normal), 1.0F, 1e-5F);
}

struct ModeCase {
    const char* file;
    scene::Topology topology;
    std::uint32_t triangles;
};

class ModeAsset : public testing::TestWithParam<ModeCase> {};

TEST_P(ModeAsset, BecomesAList) {
    if (!std::filesystem::exists(assets_folder())) GTEST_SKIP() << "no " << assets_folder();

    const auto model = broken(GetParam().file);

    ASSERT_TRUE(model) << engine::to_string(model.error());
    EXPECT_EQ(model->meshes.at(0).submeshes.at(0).topology, GetParam().topology);
    EXPECT_EQ(model->meshes[0].health.triangles, GetParam().triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Gltf,
    ModeAsset,
    testing::Values(
        ModeCase{"Mesh_PrimitiveMode_00.gltf", scene::Topology::points, 0},
        ModeCase{"Mesh_PrimitiveMode_03.gltf", scene::Topology::lines, 0},
        ModeCase{"Mesh_PrimitiveMode_04.gltf", scene::Topology::triangles, 2},
        ModeCase{"Mesh_PrimitiveMode_05.gltf", scene::Topology::triangles, 2}));

TEST(DungeonAssets, FiveOfTwentyTwoAreClosed) {
    const std::filesystem::path folder = assets_folder() / "dungeon";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;

    std::vector<std::string> closed;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".glb") continue;
        SCOPED_TRACE(entry.path());
        const auto model = scene::load_gltf(entry.path());
        ASSERT_TRUE(model) << engine::to_string(model.error());
        const bool all =
            std::all_of(model->meshes.begin(), model->meshes.end(), [](const scene::Mesh& mesh) {
                return mesh.health.closed();
            });
        if (all) closed.push_back(entry.path().stem().stem());
    }

    EXPECT_THAT(
        closed,
        testing::UnorderedElementsAre(
            "box_large", "candle_triple", "stairs_wood", "torch_lit", "trunk_large_A"));
}

} // namespace
