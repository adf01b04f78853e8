// Broken glTF files: each is refused with a sentence that names what and where.

#include "engine/scene/gltf.hpp"
#include "tests/engine/scene/gltf_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace {

using testing::HasSubstr;
using testing_gltf::Document;
using testing_gltf::triangle;

struct RefusalCase {
    const char* name;
    std::function<void(Document&)> damage;
    const char* message;
};

class GltfRefusal : public testing::TestWithParam<RefusalCase> {};

TEST_P(GltfRefusal, NamesWhatAndWhere) {
    Document document = triangle();
    ASSERT_TRUE(document.load());
    GetParam().damage(document);

    const auto model = document.load();

    ASSERT_FALSE(model);
    EXPECT_THAT(model.error().message, HasSubstr(GetParam().message));
    EXPECT_EQ(model.error().place.file, "test.gltf");
}

nlohmann::json& primitive(Document& document) {
    return document.json["meshes"][0]["primitives"][0];
}
nlohmann::json& node(Document& document) {
    return document.json["nodes"][0];
}

void set_light(Document& document, const nlohmann::json& light) {
    document.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
}
void set_camera(Document& document, double fov_y, double near) {
    document.add(
        "cameras", {{"type", "perspective"}, {"perspective", {{"yfov", fov_y}, {"znear", near}}}});
}
void set_material(Document& document, const nlohmann::json& material) {
    document.add("materials", material);
}

void set_joints(Document& document, std::uint8_t joint, const nlohmann::json& joints) {
    auto& attributes = primitive(document)["attributes"];
    attributes["JOINTS_0"] = document.accessor<std::uint8_t>(
        "VEC4", 4, {joint, 0, 0, 0, joint, 0, 0, 0, joint, 0, 0, 0});
    attributes["WEIGHTS_0"] =
        document.accessor<float>("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    document.add("skins", {{"joints", joints}});
    node(document)["skin"] = 0;
}

void set_animation(
    Document& document,
    const std::vector<float>& times,
    const std::vector<float>& values,
    const char* path,
    const char* interpolation = "LINEAR") {
    const bool rotation = std::string(path) == "rotation";
    const int input = document.accessor<float>("SCALAR", 1, times);
    const int output =
        document.accessor<float>(rotation ? "VEC4" : "VEC3", rotation ? 4 : 3, values);
    document.add(
        "animations",
        {{"name", "walk"},
         {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
}

const RefusalCase kMeshes[] = {
    {"index_past_the_end",
     [](Document& d) {
         primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 1, {0, 1, 65535});
     },
     "mesh 'Box' primitive 0: index 65535 at 2 is past its 3 vertices"},
    {"infinite_position",
     [](Document& d) {
         primitive(d)["attributes"]["POSITION"] = d.accessor<float>(
             "VEC3", 3, {0, 0, 0, 1, std::numeric_limits<float>::infinity(), 0, 0, 1, 0});
     },
     "mesh 'Box' primitive 0 POSITION: element 1 is not finite"},
    {"unknown_mode",
     [](Document& d) { primitive(d)["mode"] = 7; },
     "mesh 'Box' primitive 0: mode 7 is not known"},
    {"missing_accessor",
     [](Document& d) { primitive(d)["attributes"]["POSITION"] = 77; },
     "mesh 'Box' primitive 0 POSITION: accessor 77 of 3 does not exist"},
    {"negative_accessor",
     [](Document& d) { primitive(d)["attributes"]["POSITION"] = -1; },
     "mesh 'Box' primitive 0 POSITION: accessor -1 of 3 does not exist"},
    {"missing_material",
     [](Document& d) { primitive(d)["material"] = 2; },
     "mesh 'Box' primitive 0: material 2 of 0 does not exist"},
    {"too_few_normals",
     [](Document& d) {
         primitive(d)["attributes"]["NORMAL"] = d.accessor<float>("VEC3", 3, {0, 0, 1});
     },
     "mesh 'Box' primitive 0 NORMAL: 1 elements for 3 vertices"},
    {"positions_in_pairs",
     [](Document& d) { d.json["accessors"][0]["type"] = "VEC2"; },
     "mesh 'Box' primitive 0 POSITION: its elements have 2 components, expected 3"},
    {"accessor_past_its_view",
     [](Document& d) { d.json["accessors"][0]["count"] = 4; },
     "mesh 'Box' primitive 0 POSITION: its 4 elements end at byte 48 of a buffer view of 36 bytes"},
    {"huge_count",
     [](Document& d) {
         d.json["accessors"][0]["count"] = 2'000'000'000;
         d.json["accessors"][0].erase("bufferView");
     },
     "more than a model of this size may unpack"},
    {"wrong_number_of_weights",
     [](Document& d) {
         d.json["meshes"][0]["weights"] = {1, 2};
     },
     "mesh 'Box': 2 weights for 0 targets"},
    {"float_indices",
     [](Document& d) {
         primitive(d)["indices"] = d.accessor<float>("SCALAR", 1, {0, 1, 2});
     },
     "mesh 'Box' primitive 0 indices: component type 5126 where unsigned integers are expected"},
};

const RefusalCase kText[] = {
    {"negative_stride",
     [](Document& d) { d.json["bufferViews"][0]["byteStride"] = -12; },
     "'byteStride' is -12, expected a number from 0 up"},
    {"negative_offset",
     [](Document& d) { d.json["accessors"][0]["byteOffset"] = -4; },
     "'byteOffset' is -4, expected a number from 0 up"},
    {"fractional_index",
     [](Document& d) { node(d)["mesh"] = 0.5; },
     "'mesh' is 0.5, expected a whole number"},
    {"index_beyond_an_int",
     [](Document& d) { node(d)["mesh"] = 4'294'967'296; },
     "'mesh' is 4294967296, expected at most 2147483647"},
    {"deep_extras",
     [](Document& d) {
         nlohmann::json deep = 1;
         for (int i = 0; i < 100; ++i)
             deep = nlohmann::json::array({deep});
         d.json["extras"] = deep;
     },
     "nested deeper than 64 levels"},
    {"another_version",
     [](Document& d) { d.json["asset"]["version"] = "1.0"; },
     "glTF version '1.0', expected 2.0"},
    {"required_draco",
     [](Document& d) { d.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
     "it requires the extension 'KHR_draco_mesh_compression', which is not understood"},
    {"external_buffer",
     [](Document& d) {
         d.json["buffers"] = {{{"byteLength", 4}, {"uri", "/etc/passwd"}}};
         d.buffer.clear();
     },
     "File not found"},
};

const RefusalCase kNodes[] = {
    {"cycle",
     [](Document& d) {
         node(d)["children"] = {1};
         d.add("nodes", {{"children", {0}}});
     },
     "node 'node': is its own ancestor or has two parents, expected a tree"},
    {"two_parents",
     [](Document& d) {
         node(d)["children"] = {1, 1};
         d.add("nodes", {{"name", "shared"}});
     },
     "node 'shared': is its own ancestor or has two parents, expected a tree"},
    {"missing_child", [](Document& d) { node(d)["children"] = {5}; }, "node 5 of 1 does not exist"},
    {"missing_scene", [](Document& d) { d.json["scene"] = 3; }, "scene 3 of 1 does not exist"},
    {"missing_mesh",
     [](Document& d) { node(d)["mesh"] = 3; },
     "node 'node': mesh 3 of 1 does not exist"},
    {"missing_skin",
     [](Document& d) { node(d)["skin"] = 3; },
     "node 'node': skin 3 of 0 does not exist"},
    {"missing_camera",
     [](Document& d) { node(d)["camera"] = 3; },
     "node 'node': camera 3 of 0 does not exist"},
    {"zero_rotation",
     [](Document& d) {
         node(d)["rotation"] = {0, 0, 0, 0};
     },
     "node 'node': its rotation is zero"},
    {"short_translation",
     [](Document& d) {
         node(d)["translation"] = {1, 2};
     },
     "node 'node': translation has 2 numbers, expected 3"},
    {"short_matrix",
     [](Document& d) {
         node(d)["matrix"] = {1, 2, 3};
     },
     "node 'node': matrix has 3 numbers, expected 16"},
    {"far_translation",
     [](Document& d) {
         node(d)["translation"] = {1e30, 0, 0};
     },
     "node 'node': translation is 1e+30, expected -1e+09 to 1e+09"},
    {"scales_that_multiply",
     [](Document& d) {
         node(d)["scale"] = {1e8, 1, 1};
         node(d)["children"] = {1};
         d.add("nodes", {{"name", "inner"}, {"scale", {1, 1e8, 1}}});
     },
     "node 'inner': scales multiply to 1e+16"},
    {"wrong_number_of_node_weights",
     [](Document& d) { node(d)["weights"] = {1}; },
     "node 'node': 1 weights for 0 targets"},
};

const RefusalCase kMaterials[] = {
    {"unknown_alpha_mode",
     [](Document& d) {
         set_material(d, {{"name", "m"}, {"alphaMode", "GLASS"}});
     },
     "material 'm': alpha mode 'GLASS' is not known"},
    {"negative_colour",
     [](Document& d) {
         set_material(d, {{"pbrMetallicRoughness", {{"baseColorFactor", {1, -1, 1, 1}}}}});
     },
     "material 0: baseColorFactor is -1"},
    {"missing_texture",
     [](Document& d) {
         set_material(d, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 4}}}}}});
     },
     "material 0: texture 4 of 0 does not exist"},
    {"missing_image",
     [](Document& d) {
         d.add("textures", {{"source", 6}});
         set_material(d, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
     },
     "texture 0: image 6 of 0 does not exist"},
    {"unknown_wrap_mode",
     [](Document& d) {
         d.add("samplers", {{"wrapS", 5}});
         d.add("textures", {{"sampler", 0}});
         set_material(d, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
     },
     "texture 0: wrap mode 5 is not known"},
};

const RefusalCase kCamerasAndLights[] = {
    {"wide_camera", [](Document& d) { set_camera(d, 4.0, 0.1); }, "camera 0: yfov is 4"},
    {"camera_without_near_plane",
     [](Document& d) { set_camera(d, 1.0, 0.0); },
     "camera 0: znear is 0"},
    {"unknown_light",
     [](Document& d) {
         set_light(d, {{"name", "l"}, {"type", "area"}});
     },
     "light 'l': type 'area' is not known"},
    {"cone_inside_out",
     [](Document& d) {
         set_light(
             d, {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.75}, {"outerConeAngle", 0.5}}}});
     },
     "light 0: inner cone angle 0.75 is not below outer cone angle 0.5"},
    {"wide_cone",
     [](Document& d) {
         set_light(d, {{"type", "spot"}, {"spot", {{"outerConeAngle", 2}}}});
     },
     "light 0: outerConeAngle is 2"},
    {"negative_intensity",
     [](Document& d) {
         set_light(d, {{"type", "point"}, {"intensity", -1}});
     },
     "light 0: intensity is -1"},
    {"missing_light",
     [](Document& d) {
         set_light(d, {{"type", "point"}});
         node(d)["extensions"]["KHR_lights_punctual"]["light"] = 4;
     },
     "node 'node': light 4 of 1 does not exist"},
};

const RefusalCase kMotion[] = {
    {"missing_joint",
     [](Document& d) { set_joints(d, 0, {9}); },
     "skin 0: joint node 9 of 1 does not exist"},
    {"joint_past_the_skin",
     [](Document& d) { set_joints(d, 3, {0}); },
     "node 'node': joint 3 at vertex 0 is past the 1 joints of its skin"},
    {"too_few_inverse_binds",
     [](Document& d) {
         set_joints(d, 0, {0, 0});
         d.json["skins"][0]["inverseBindMatrices"] =
             d.accessor<float>("MAT4", 16, std::vector<float>(16, 1.0F));
     },
     "skin 0: 1 inverse bind matrices for 2 joints"},
    {"times_that_fall",
     [](Document& d) {
         set_animation(d, {1, 0.5}, {0, 0, 0, 1, 1, 1}, "translation");
     },
     "animation 'walk' channel 0: time 0.5 at key 1 does not rise"},
    {"too_few_values",
     [](Document& d) {
         set_animation(d, {0, 1}, {0, 0, 0}, "scale");
     },
     "animation 'walk' channel 0: 3 numbers for 2 keys, expected 6"},
    {"zero_rotation_key",
     [](Document& d) {
         set_animation(d, {0}, {0, 0, 0, 0}, "rotation");
     },
     "animation 'walk' channel 0: the rotation of key 0 is zero"},
    {"unknown_interpolation",
     [](Document& d) {
         set_animation(d, {0}, {0, 0, 0}, "scale", "SMOOTH");
     },
     "animation 'walk' channel 0: interpolation 'SMOOTH' is not known"},
    {"missing_sampler",
     [](Document& d) {
         set_animation(d, {0}, {0, 0, 0}, "scale");
         d.json["animations"][0]["channels"][0]["sampler"] = 3;
     },
     "animation 'walk' channel 0: sampler 3 of 1 does not exist"},
    {"missing_target",
     [](Document& d) {
         set_animation(d, {0}, {0, 0, 0}, "scale");
         d.json["animations"][0]["channels"][0]["target"]["node"] = 8;
     },
     "animation 'walk' channel 0: node 8 of 1 does not exist"},
};

const auto kCaseName = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Meshes, GltfRefusal, testing::ValuesIn(kMeshes), kCaseName);
INSTANTIATE_TEST_SUITE_P(Text, GltfRefusal, testing::ValuesIn(kText), kCaseName);
INSTANTIATE_TEST_SUITE_P(Nodes, GltfRefusal, testing::ValuesIn(kNodes), kCaseName);
INSTANTIATE_TEST_SUITE_P(Materials, GltfRefusal, testing::ValuesIn(kMaterials), kCaseName);
INSTANTIATE_TEST_SUITE_P(
    CamerasAndLights, GltfRefusal, testing::ValuesIn(kCamerasAndLights), kCaseName);
INSTANTIATE_TEST_SUITE_P(Motion, GltfRefusal, testing::ValuesIn(kMotion), kCaseName);

std::string refusal(const std::vector<std::uint8_t>& bytes) {
    const auto model = scene::load_gltf_bytes(bytes, "test.glb");
    return model ? "read" : model.error().message;
}

TEST(GltfRefusals, TextThatIsNotJson) {
    EXPECT_THAT(refusal({'{', '"', 'a'}), HasSubstr("not readable as JSON"));
    EXPECT_THAT(refusal({}), HasSubstr("not readable as JSON"));
    EXPECT_THAT(refusal({'[', ']', ' ', ' '}), HasSubstr("not readable as glTF"));
}

TEST(GltfRefusals, BinaryFilesThatEndEarly) {
    const std::vector<std::uint8_t> whole = triangle().binary();
    ASSERT_EQ(refusal(whole), "read");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        SCOPED_TRACE(size);
        EXPECT_NE(
            refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "read");
    }
}

TEST(GltfRefusals, ChunksThatReachPastTheEnd) {
    std::vector<std::uint8_t> long_text = triangle().binary();
    long_text[14] = 0xFF;
    std::vector<std::uint8_t> long_buffer = triangle().binary();
    const std::size_t text_bytes = long_buffer[12] + 256U * long_buffer[13];
    long_buffer[20 + text_bytes] = static_cast<std::uint8_t>(long_buffer[20 + text_bytes] + 4);

    EXPECT_THAT(refusal(long_text), HasSubstr("its JSON chunk of"));
    EXPECT_THAT(refusal(long_buffer), HasSubstr("its BIN chunk of"));
}

TEST(GltfRefusals, AFileThatIsNotThere) {
    const auto model = scene::load_gltf("nowhere/at_all.gltf");

    ASSERT_FALSE(model);
    EXPECT_EQ(engine::to_string(model.error()), "nowhere/at_all.gltf: no such file");
}

} // namespace
