// Skins, morph targets and animations out of glTF.

#include "engine/scene/gltf.hpp"
#include "tests/engine/scene/gltf_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_gltf::Document;
using testing_gltf::loaded;
using testing_gltf::triangle;

Document with_skin() {
    Document document = triangle();
    auto& attributes = document.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] =
        document.accessor<std::uint8_t>("VEC4", 4, {0, 1, 9, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    attributes["WEIGHTS_0"] =
        document.accessor<float>("VEC4", 4, {1, 3, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    document.json["nodes"][0]["skin"] = 0;
    document.add("nodes", {{"name", "hip"}, {"children", {2}}});
    document.add("nodes", {{"name", "knee"}});
    document.add("skins", {{"joints", {2, 1}}});
    document.json["scenes"][0]["nodes"] = {0, 1};
    return document;
}

TEST(GltfMotion, SkinsNameJointsOfTheModelAndWeightsAddUpToOne) {
    const scene::Model model = loaded(with_skin());

    EXPECT_THAT(model.skins.at(0).joints, ElementsAre(2, 1));
    EXPECT_EQ(model.skins[0].joint_from_mesh, std::vector<glm::mat4>(2, glm::mat4(1)));
    const auto& influences = model.meshes[0].influences;
    EXPECT_EQ(influences[0].weights, glm::vec4(0.25F, 0.75F, 0, 0));
    EXPECT_EQ(influences[0].joints, (std::array<std::uint16_t, 4>{0, 1, 0, 0})); // 9 has no weight
    EXPECT_EQ(influences[2].weights, glm::vec4(1, 0, 0, 0));
}

TEST(GltfMotion, FurtherJointSetsAreIgnoredWithAWarning) {
    Document document = with_skin();
    document.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_1"] = 0;

    EXPECT_THAT(
        loaded(document).warnings, ElementsAre(HasSubstr("only four joints move a vertex")));
}

TEST(GltfMotion, MorphTargetsMayBeSparse) {
    Document document = triangle();
    const std::array<std::uint8_t, 4> place = {2, 0, 0, 0};
    const std::array<float, 3> offset = {0, 0, 5};
    const int places = document.view(place.data(), 1);
    const int values = document.view(offset.data(), sizeof offset);
    const int target = document.add(
        "accessors",
        {{"componentType", 5126},
         {"count", 3},
         {"type", "VEC3"},
         {"sparse",
          {{"count", 1},
           {"indices", {{"bufferView", places}, {"componentType", 5121}}},
           {"values", {{"bufferView", values}}}}}});
    document.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    document.json["meshes"][0]["weights"] = {0.5};
    document.json["nodes"][0]["weights"] = {0.75};

    const scene::Model model = loaded(document);

    const scene::Mesh& mesh = model.meshes[0];
    EXPECT_THAT(
        mesh.morph_targets.at(0).position_deltas,
        ElementsAre(glm::vec3(0), glm::vec3(0), glm::vec3(0, 0, 5)));
    EXPECT_THAT(mesh.morph_weights, ElementsAre(0.5F));
    EXPECT_THAT(model.nodes[0].morph_weights, ElementsAre(0.75F));
    EXPECT_THAT(mesh.patches, IsEmpty());
}

TEST(GltfMotion, AnimationsBecomeClips) {
    Document document = triangle();
    const int times = document.accessor<float>("SCALAR", 1, {0, 2});
    const int turns = document.accessor<std::int16_t>("VEC4", 4, {0, 0, 0, 32767, 0, 32767, 0, 0});
    document.json["accessors"][static_cast<std::size_t>(turns)]["normalized"] = true;
    document.add(
        "animations",
        {{"name", "turn"},
         {"samplers", {{{"input", times}, {"output", turns}, {"interpolation", "STEP"}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});

    const scene::Model model = loaded(document);

    const scene::AnimationClip& clip = model.clips.at(0);
    EXPECT_EQ(clip.name, "turn");
    EXPECT_EQ(clip.duration, 2.0F);
    EXPECT_EQ(clip.channels.at(0).interpolation, scene::Interpolation::step);
    EXPECT_THAT(clip.channels[0].values, ElementsAre(0, 0, 0, 1, 0, 1, 0, 0));
}

} // namespace
