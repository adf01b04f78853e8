// What a sound glTF file becomes.

#include "engine/scene/gltf.hpp"
#include "tests/engine/scene/gltf_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_gltf::Document;
using testing_gltf::loaded;
using testing_gltf::triangle;

/// A 1x1 PNG, red with alpha 0x80.
constexpr const char* kRedPixel =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nG"
    "P4z8DQAAAEgQGALFXOsAAAAABJRU5ErkJggg==";

Document with_material(const nlohmann::json& material) {
    Document document = triangle();
    document.add("materials", material);
    document.json["meshes"][0]["primitives"][0]["material"] = 0;
    return document;
}

Document with_light(const nlohmann::json& light) {
    Document document = triangle();
    document.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    document.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    return document;
}

TEST(Gltf, ATriangleIsReadWhole) {
    const scene::Model model = loaded(triangle());

    ASSERT_EQ(model.meshes.size(), 1U);
    const scene::Mesh& mesh = model.meshes[0];
    EXPECT_EQ(mesh.name, "Box");
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.bounds.max, glm::vec3(1, 1, 0));
    EXPECT_EQ(mesh.health.triangles, 1U);
    EXPECT_EQ(mesh.patches.size(), 1U);
    ASSERT_EQ(model.nodes.size(), 1U);
    EXPECT_EQ(model.nodes[0].mesh, 0U);
    ASSERT_EQ(model.materials.size(), 1U);
    EXPECT_EQ(model.materials[0].base_color, glm::vec4(1));
    EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(Gltf, BinaryFilesGiveTheSame) {
    const auto bytes = triangle().binary();

    const auto model = scene::load_gltf_bytes(bytes, "test.glb");

    ASSERT_TRUE(model) << engine::to_string(model.error());
    EXPECT_EQ(model->meshes[0].positions, loaded(triangle()).meshes[0].positions);
}

TEST(Gltf, WithoutIndicesVerticesFollowOneAnother) {
    Document document = triangle();
    document.json["meshes"][0]["primitives"][0].erase("indices");

    EXPECT_THAT(loaded(document).meshes[0].indices, ElementsAre(0, 1, 2));
}

TEST(Gltf, MissingNormalsAreFlat) {
    Document document = triangle();
    document.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");

    EXPECT_EQ(loaded(document).meshes[0].normals[2], glm::vec3(0, 0, 1));
}

TEST(Gltf, BadNormalsAreMadeAnewWithAWarning) {
    Document document = triangle();
    document.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        document.accessor<float>("VEC3", 3, {0, 0, 0, NAN, 0, 0, 0, 0, 2});

    const scene::Model model = loaded(document);

    EXPECT_EQ(model.meshes[0].normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
    EXPECT_THAT(
        model.warnings,
        ElementsAre("mesh 'Box' primitive 0: 3 normals were not of length 1 and are made anew"));
}

TEST(Gltf, PrimitivesOfAMeshAreItsSubmeshes) {
    Document document = triangle();
    document.add("materials", {{"name", "red"}});
    auto& primitives = document.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[0]["material"] = 0;
    primitives[1]["mode"] = 0;
    primitives[1]["attributes"]["TEXCOORD_0"] =
        document.accessor<float>("VEC2", 2, {1, 2, 3, 4, 5, 6});

    const scene::Model model = loaded(document);

    const scene::Mesh& mesh = model.meshes[0];
    ASSERT_EQ(mesh.submeshes.size(), 2U);
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_EQ(mesh.submeshes[1].first_index, 3U);
    EXPECT_EQ(mesh.submeshes[1].topology, scene::Topology::points);
    EXPECT_EQ(mesh.uvs.size(), 6U);
    EXPECT_EQ(mesh.uvs[4], glm::vec2(3, 4));
    EXPECT_EQ(model.materials[mesh.submeshes[0].material].name, "red");
    EXPECT_EQ(model.materials[mesh.submeshes[1].material].name, "default");
}

TEST(Gltf, NodesComeParentsFirstUnderUniqueNames) {
    Document document = triangle();
    document.json["nodes"] = {
        {{"name", "Cube"}},
        {{"name", "Cube"}, {"children", {0, 3}}},
        {{"name", "Cube.001"}},
        nlohmann::json::object()};
    document.json["scenes"][0]["nodes"] = {1, 2};

    const scene::Model model = loaded(document);

    std::vector<std::string> names;
    for (const scene::Node& node : model.nodes)
        names.push_back(node.name);
    EXPECT_THAT(names, ElementsAre("Cube", "Cube.001", "node 3", "Cube.001.001"));
    EXPECT_EQ(model.nodes[1].parent, 0U);
    EXPECT_EQ(model.nodes[2].parent, 0U);
    EXPECT_FALSE(model.nodes[3].parent);
}

TEST(Gltf, OnlyTheDefaultSceneIsRead) {
    Document document = triangle();
    document.add("nodes", {{"name", "elsewhere"}});
    document.add("scenes", {{"nodes", {1}}});
    document.json["scene"] = 1;

    const scene::Model model = loaded(document);

    ASSERT_EQ(model.nodes.size(), 1U);
    EXPECT_EQ(model.nodes[0].name, "elsewhere");
}

TEST(Gltf, WithoutASceneNodesThatAreNobodysChildrenAreRoots) {
    Document document = triangle();
    document.json.erase("scenes");
    document.json.erase("scene");
    document.add("nodes", {{"children", {0}}});

    const scene::Model model = loaded(document);

    ASSERT_EQ(model.nodes.size(), 2U);
    EXPECT_EQ(model.nodes[1].name, "node");
    EXPECT_EQ(model.nodes[1].parent, 0U);
}

TEST(Gltf, OneMeshMayStandInManyNodes) {
    Document document = triangle();
    document.add("nodes", {{"mesh", 0}, {"scale", {-1, 2, 3}}});
    document.json["scenes"][0]["nodes"] = {0, 1};

    const scene::Model model = loaded(document);

    EXPECT_EQ(model.meshes.size(), 1U);
    EXPECT_EQ(model.nodes[1].mesh, 0U);
    EXPECT_EQ(model.nodes[1].local.scale, glm::vec3(-1, 2, 3));
}

TEST(Gltf, MirroringMatricesAreTakenApart) {
    Document document = triangle();
    document.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, -2, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};

    const scene::Model model = loaded(document);

    const glm::dmat4 matrix = model.nodes[0].local.matrix();
    EXPECT_NEAR(matrix[1][1], -2.0, 1e-6);
    EXPECT_EQ(glm::dvec3(matrix[3]), glm::dvec3(5, 6, 7));
    EXPECT_LT(glm::determinant(matrix), 0.0);
    EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(Gltf, ShearedMatricesAreToldOf) {
    Document document = triangle();
    document.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    EXPECT_THAT(
        loaded(document).warnings, ElementsAre(HasSubstr("node 'node': its matrix is sheared")));
}

TEST(Gltf, RotationsAreMadeUnit) {
    Document document = triangle();
    document.json["nodes"][0]["rotation"] = {0, 0, 3, 4};

    EXPECT_FLOAT_EQ(loaded(document).nodes[0].local.rotation.z, 0.6F);
}

TEST(Gltf, MaterialsHaveBaseColourMaskAndSides) {
    const scene::Model model = loaded(with_material(
        {{"name", "leaf"},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.25},
         {"doubleSided", true},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}}}}));

    const scene::Material& material = model.materials[0];
    EXPECT_EQ(material.name, "leaf");
    EXPECT_EQ(material.base_color, glm::vec4(0.5F, 0.25F, 0.125F, 1.0F));
    EXPECT_TRUE(material.alpha_masked);
    EXPECT_EQ(material.alpha_cutoff, 0.25F);
    EXPECT_TRUE(material.double_sided);
}

TEST(Gltf, BlendIsMaskAtOneHalfWithAWarning) {
    const scene::Model model =
        loaded(with_material({{"name", "glass"}, {"alphaMode", "BLEND"}, {"alphaCutoff", 0.9}}));

    EXPECT_TRUE(model.materials[0].alpha_masked);
    EXPECT_EQ(model.materials[0].alpha_cutoff, 0.5F);
    EXPECT_THAT(model.warnings, ElementsAre("material 'glass': BLEND is drawn as MASK at 0.5"));
}

TEST(Gltf, PicturesAreDecodedWithTheirSampler) {
    Document document =
        with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    document.add("images", {{"name", "red"}, {"uri", kRedPixel}});
    document.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    document.add("textures", {{"source", 0}, {"sampler", 0}});

    const scene::Model model = loaded(document);

    ASSERT_EQ(model.textures.size(), 1U);
    const scene::Texture& texture = model.textures[0];
    EXPECT_EQ(model.materials[0].texture, 0U);
    EXPECT_EQ(texture.name, "red");
    EXPECT_THAT(texture.image.bytes, ElementsAre(255, 0, 0, 128));
    EXPECT_EQ(texture.wrap_u, scene::Wrap::clamp);
    EXPECT_EQ(texture.wrap_v, scene::Wrap::mirror);
    EXPECT_TRUE(texture.nearest);
}

TEST(Gltf, MissingAndUnreadablePicturesAreWhiteWithAWarning) {
    for (const char* uri : {"nowhere.png", "data:image/png;base64,AAAA"}) {
        SCOPED_TRACE(uri);
        Document document =
            with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        document.add("images", {{"name", "lost"}, {"uri", uri}});
        document.add("textures", {{"source", 0}});

        const scene::Model model = loaded(document);

        EXPECT_EQ(model.materials.at(0).texture, scene::kNoTexture);
        EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("image 'lost'")));
    }
}

TEST(Gltf, MaterialsChooseTheirTextureCoordinates) {
    Document document = with_material(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}});
    document.add("images", {{"uri", kRedPixel}});
    document.add("textures", {{"source", 0}});
    auto& attributes = document.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = document.accessor<float>("VEC2", 2, {0, 0, 0, 0, 0, 0});
    attributes["TEXCOORD_1"] = document.accessor<float>("VEC2", 2, {7, 0, 0, 0, 0, 0});

    EXPECT_EQ(loaded(document).meshes[0].uvs[0], glm::vec2(7, 0));
}

TEST(Gltf, PerspectiveCamerasAreReadAndOthersLeftOut) {
    Document document = triangle();
    document.add(
        "cameras",
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}});
    document.add(
        "cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}});
    document.json["nodes"][0]["camera"] = 1;
    document.add("nodes", {{"camera", 0}});
    document.json["scenes"][0]["nodes"] = {0, 1};

    const scene::Model model = loaded(document);

    ASSERT_EQ(model.cameras.size(), 1U);
    EXPECT_EQ(model.cameras[0].fov_y, 0.5F);
    EXPECT_EQ(model.cameras[0].near, 0.25F);
    EXPECT_EQ(model.nodes[0].camera, 0U);
    EXPECT_FALSE(model.nodes[1].camera);
    EXPECT_THAT(model.warnings, ElementsAre("camera 0: orthographic cameras are left out"));
}

TEST(Gltf, LightsHaveTheDefaultsOfTheirExtension) {
    const scene::Model model =
        loaded(with_light({{"type", "spot"}, {"spot", nlohmann::json::object()}}));

    const scene::Light& light = model.lights.at(0);
    EXPECT_EQ(model.nodes[0].light, 0U);
    EXPECT_EQ(light.kind, scene::LightKind::spot);
    EXPECT_EQ(light.color, glm::vec3(1));
    EXPECT_EQ(light.intensity, 1.0F);
    EXPECT_EQ(light.range, std::numeric_limits<float>::infinity());
    EXPECT_EQ(light.inner_angle, 0.0F);
    EXPECT_FLOAT_EQ(light.outer_angle, 0.78539816F);
}

TEST(Gltf, LightsHaveWhatTheFileSays) {
    const scene::Light point =
        loaded(with_light(
                   {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 40}, {"range", 8}}))
            .lights.at(0);
    const scene::Light sun =
        loaded(with_light({{"type", "directional"}, {"intensity", 60000}})).lights.at(0);

    EXPECT_EQ(point.kind, scene::LightKind::point);
    EXPECT_EQ(point.color, glm::vec3(1, 0.5F, 0));
    EXPECT_EQ(point.intensity, 40.0F);
    EXPECT_EQ(point.range, 8.0F);
    EXPECT_EQ(sun.kind, scene::LightKind::directional);
    EXPECT_EQ(sun.intensity, 60000.0F);
}

TEST(Gltf, NumbersInExtrasMeanNothing) {
    Document document = triangle();
    document.json["nodes"][0]["extras"] = {{"count", -3}, {"deep", {{"mesh", 1.5}}}};

    EXPECT_THAT(loaded(document).warnings, IsEmpty());
}

} // namespace
