#include "engine/scene/framing.hpp"
#include "engine/scene/scene_builder.hpp"
#include "engine/scene/views.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace scene {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ModelDescription shape(const std::string& name, const std::string& kind, const glm::vec3& size) {
    ModelDescription model;
    model.name = name;
    model.shape = kind;
    model.size = size;
    return model;
}

ecs::Entity find(const World& world, const std::string& name) {
    ecs::Entity found;
    world.registry.each<Name>([&](ecs::Entity entity, const Name& candidate) {
        if (candidate.text == name) found = entity;
    });
    return found;
}

constexpr const char* kBranchAndLeaf =
    R"({"name":"branch","children":[1]},{"name":"leaf","mesh":0})";

/// A file of its own with one triangle as mesh 0.
/// @param nodes the first is the root of the scene
/// @param extensions ends the document
std::filesystem::path
write_triangle(const std::string& nodes = kBranchAndLeaf, const std::string& extensions = "") {
    const auto file = std::filesystem::temp_directory_path() / "gnomon_builder_triangle.gltf";
    std::ofstream(file)
        << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" << nodes
        << R"(],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])"
        << extensions << "}";
    return file;
}

TEST(SceneBuilder, MakesShapesOfTheirFullSize) {
    SceneDescription level;
    const glm::vec3 size(2.0F, 0.5F, 3.0F);
    for (const char* kind : {"box", "sphere", "cylinder", "cone", "torus"})
        level.models.push_back(shape(kind, kind, size));
    World world;

    ASSERT_TRUE(build_world(level, ".", world));

    for (const ModelDescription& model : level.models) {
        SCOPED_TRACE(model.name);
        const glm::dvec3 extent = world_bounds(world, find(world, model.name)).extent();
        EXPECT_NEAR(extent.x, 2.0, 0.02);
        EXPECT_NEAR(extent.y, 0.5, 0.02);
        EXPECT_NEAR(extent.z, 3.0, 0.02);
    }
}

TEST(SceneBuilder, SharesTheMeshesOfEqualShapes) {
    SceneDescription level;
    level.models = {
        shape("a", "box", {1, 1, 1}), shape("b", "box", {1, 1, 1}), shape("c", "box", {1, 1, 1})};
    level.models[2].color = glm::vec4(1.0F, 0.0F, 0.0F, 1.0F);
    World world;

    ASSERT_TRUE(build_world(level, ".", world));

    const auto mesh = [&](const char* name) {
        return world.registry.get<MeshInstance>(find(world, name)).mesh;
    };
    EXPECT_EQ(mesh("a"), mesh("b"));
    EXPECT_NE(mesh("a"), mesh("c"));
    const std::uint32_t material = world.assets.meshes[mesh("c")].submeshes.at(0).material;
    EXPECT_EQ(world.assets.materials[material].base_color.y, 0.0F);
}

TEST(SceneBuilder, GivesEveryMeshOfAModelItsPartInShadows) {
    SceneDescription level;
    ModelDescription model;
    model.name = "hero";
    model.file = write_triangle().filename().string();
    model.casts = false;
    model.hero = true;
    level.models = {model, model};
    level.models[1].name = "extra";
    level.models[1].hero = false;
    World world;

    ASSERT_TRUE(build_world(level, std::filesystem::temp_directory_path(), world));

    const auto& hero = world.registry.get<ShadowRole>(find(world, "hero/leaf"));
    EXPECT_TRUE(hero.hero);
    EXPECT_FALSE(hero.casts);
    EXPECT_FALSE(world.registry.get<ShadowRole>(find(world, "extra/leaf")).hero);
    EXPECT_EQ(world.assets.meshes.size(), 1U);
}

TEST(SceneBuilder, NamesTheModelThatCannotBeRead) {
    SceneDescription level;
    ModelDescription model;
    model.name = "hero";
    model.file = "nowhere.glb";
    model.place = {"yard.lua", 7};
    level.models = {model};
    World world;

    const auto built = build_world(level, ".", world);

    ASSERT_FALSE(built);
    EXPECT_THAT(engine::to_string(built.error()), HasSubstr("yard.lua:7: model \"hero\": "));
}

TEST(SceneBuilder, NamesAClipThatIsNotThere) {
    SceneDescription level;
    ModelDescription model;
    model.name = "hero";
    model.file = write_triangle().filename().string();
    model.animation = "Run";
    level.models = {model};
    World world;

    const auto built = build_world(level, std::filesystem::temp_directory_path(), world);

    ASSERT_FALSE(built);
    EXPECT_THAT(built.error().message, HasSubstr("animation is \"Run\", which is no clip of"));
}

TEST(SceneBuilder, LightsAPlainFileThatIsDark) {
    World world;

    const auto warnings = build_world_from_gltf(write_triangle(), world);

    ASSERT_TRUE(warnings) << engine::to_string(warnings.error());
    EXPECT_THAT(*warnings, ElementsAre(HasSubstr("has no light"), HasSubstr("has no camera")));
    ASSERT_EQ(placed_lights(world).size(), 1U);
    EXPECT_EQ(placed_lights(world)[0].name, "sun");
    EXPECT_LT(placed_lights(world)[0].direction.y, -0.5F);
    EXPECT_FALSE(find_camera(world, "", 10, 10).has_value());
}

TEST(SceneBuilder, KeepsTheLightsOfAPlainFile) {
    World world;

    const auto warnings = build_world_from_gltf(
        write_triangle(
            R"({"name":"branch","mesh":0,"children":[1]},
               {"name":"bulb","extensions":{"KHR_lights_punctual":{"light":0}}})",
            R"(,"extensionsUsed":["KHR_lights_punctual"],
               "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}})"),
        world);

    ASSERT_TRUE(warnings) << engine::to_string(warnings.error());
    ASSERT_EQ(placed_lights(world).size(), 1U);
    EXPECT_EQ(placed_lights(world)[0].name, "bulb");
}

TEST(Views, SortLightsByNameAndLeaveOutThoseThatAreOff) {
    SceneDescription level;
    for (const char* name : {"b", "off", "a"}) {
        LightDescription light;
        light.name = name;
        light.light.kind = LightKind::spot;
        light.light.on = light.name != "off";
        light.transform.position = {1.0, 2.0, 3.0};
        light.transform.rotation = rotation_along({0.0, -3.0, 0.0});
        level.lights.push_back(light);
    }
    World world;
    ASSERT_TRUE(build_world(level, ".", world));

    const std::vector<PlacedLight> lights = placed_lights(world);

    ASSERT_EQ(lights.size(), 2U);
    EXPECT_EQ(lights[0].name, "a");
    EXPECT_EQ(lights[1].name, "b");
    EXPECT_EQ(lights[0].position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(lights[0].direction.y, -1.0F, 1e-5F);
}

TEST(Views, FindTheFirstCameraOrTheOneThatIsNamed) {
    SceneDescription level;
    for (const char* name : {"second_by_name", "a"}) {
        CameraDescription camera;
        camera.name = name;
        camera.transform.rotation = rotation_along({1.0, 0.0, 0.0});
        camera.transform.scale = {2.0F, 2.0F, 2.0F};
        level.cameras.push_back(camera);
    }
    World world;
    ASSERT_TRUE(build_world(level, ".", world));

    const auto first = find_camera(world, "", 64, 32);

    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->name, "second_by_name");
    EXPECT_EQ(first->width, 64);
    EXPECT_NEAR(-first->world_from_view[2].x, 1.0F, 1e-5F);
    EXPECT_TRUE(find_camera(world, "a", 1, 1).has_value());
    EXPECT_FALSE(find_camera(world, "c", 1, 1).has_value());
    EXPECT_THAT(camera_names(world), ElementsAre("second_by_name", "a"));
}

class FramedWorlds : public ::testing::TestWithParam<float> {};

TEST_P(FramedWorlds, AreSeenWhole) {
    SceneDescription level;
    level.models = {
        shape("a", "box", glm::vec3(GetParam())), shape("b", "sphere", glm::vec3(GetParam()))};
    level.models[1].transform.position = {static_cast<double>(GetParam()) * 9.0, 0.0, 0.0};
    World world;
    ASSERT_TRUE(build_world(level, ".", world));

    for (const glm::ivec2 size : {glm::ivec2(200, 100), glm::ivec2(50, 100)}) {
        const CameraView view = frame_scene(world, size.x, size.y);
        const engine::WorldAabb bounds = world_bounds(world);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 at = view.project(bounds.corner(corner));
            EXPECT_GT(at.z, static_cast<double>(view.near));
            EXPECT_TRUE(at.x >= 0.0 && at.x <= size.x && at.y >= 0.0 && at.y <= size.y);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Framing, FramedWorlds, ::testing::Values(0.001F, 1.0F, 10'000.0F));

TEST(Framing, LooksStraightDownWithoutNaN) {
    for (const glm::dvec3 direction :
         {glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 0), glm::dvec3(1e-9, -1, 0)}) {
        const glm::vec3 looks = rotation_along(direction) * glm::vec3(0.0F, 0.0F, -1.0F);
        EXPECT_NEAR(looks.y, static_cast<float>(direction.y), 1e-5F);
    }
}

TEST(Framing, FramesAnEmptyWorld) {
    const CameraView view = frame_scene(World(), 10, 10);

    EXPECT_GT(view.project({0.0, 0.0, 0.0}).z, 0.0);
}

} // namespace

} // namespace scene
