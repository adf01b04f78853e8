// Levels that are right, and what becomes of them.

#include "tests/engine/script/levels.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace script {

namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

scene::SceneDescription good(const std::string& text) {
    LoadedScene loaded = testing::load(text);
    EXPECT_TRUE(loaded.scene.has_value()) << loaded.error_text();
    return loaded.scene.value_or(scene::SceneDescription());
}

scene::SceneDescription good_parts(const std::string& parts) {
    return good("return g.scene { " + parts + " }");
}

/// The way something turned by `rotation` looks.
glm::vec3 looks_along(const glm::quat& rotation) {
    return rotation * glm::vec3(0.0F, 0.0F, -1.0F);
}

void expect_near(const glm::vec3& left, const glm::vec3& right) {
    EXPECT_LT(glm::length(left - right), 1e-5F) << left.x << " " << left.y << " " << left.z;
}

TEST(SceneLoader, ReadsEveryFieldOfASun) {
    const auto scene =
        good_parts("g.sun { name = 'noon', direction = {0, -2, 0}, illuminance = 5, angular_size = "
                   "2, color = {1, 0.5, 0}, "
                   "on = false, shadow = { casts = false, technique = 'cascaded_map', never = "
                   "{'blob', 'none'}, error_px = 2, "
                   "map_size = 1024, filter = 'pcss', samples = 16, cascades = 3 } }");

    ASSERT_EQ(scene.lights.size(), 1U);
    const scene::LightDescription& sun = scene.lights[0];
    EXPECT_EQ(sun.name, "noon");
    EXPECT_EQ(sun.light.kind, scene::LightKind::directional);
    expect_near(looks_along(sun.transform.rotation), {0.0F, -1.0F, 0.0F});
    EXPECT_FLOAT_EQ(sun.light.intensity, 5.0F);
    EXPECT_FLOAT_EQ(sun.light.angular_radius, glm::radians(1.0F));
    expect_near(sun.light.color, {1.0F, 0.5F, 0.0F});
    EXPECT_FALSE(sun.light.on);
    EXPECT_FALSE(sun.light.casts_shadow);
    EXPECT_EQ(sun.shadow.technique, "cascaded_map");
    EXPECT_EQ(sun.shadow.never, (std::vector<std::string>{"blob", "none"}));
    EXPECT_EQ(sun.shadow.error_px, 2.0F);
    EXPECT_EQ(sun.shadow.map_size, 1024);
    EXPECT_EQ(sun.shadow.filter, "pcss");
    EXPECT_EQ(sun.shadow.samples, 16);
    EXPECT_EQ(sun.shadow.cascades, 3);
    EXPECT_EQ(sun.place.file, "yard.lua");
    EXPECT_EQ(sun.place.line, 2);
}

TEST(SceneLoader, TakesTheSchemasDefaults) {
    const auto scene = good_parts("g.sun {}, g.spot {}, g.lamp {}");

    ASSERT_EQ(scene.lights.size(), 3U);
    EXPECT_FLOAT_EQ(scene.lights[0].light.intensity, 60000.0F);
    EXPECT_FLOAT_EQ(scene.lights[0].light.angular_radius, glm::radians(0.265F));
    EXPECT_FLOAT_EQ(scene.lights[1].light.outer_angle, glm::radians(45.0F));
    EXPECT_TRUE(std::isinf(scene.lights[2].light.range));
    EXPECT_TRUE(scene.lights[2].light.casts_shadow);
    EXPECT_FALSE(scene.lights[2].shadow.technique.has_value());
    EXPECT_FALSE(scene.shadow_ms.has_value());
}

TEST(SceneLoader, AimsASpotAtItsTarget) {
    const auto scene = good_parts("g.spot { position = {1, 2, 3}, target = {1, 2, -7}, outer_angle "
                                  "= 30, inner_angle = 10, range = 4, radius = 0.5 }");

    const scene::LightDescription& spot = scene.lights.at(0);
    expect_near(looks_along(spot.transform.rotation), {0.0F, 0.0F, -1.0F});
    EXPECT_FLOAT_EQ(spot.light.outer_angle, glm::radians(30.0F));
    EXPECT_FLOAT_EQ(spot.light.inner_angle, glm::radians(10.0F));
    EXPECT_FLOAT_EQ(spot.light.range, 4.0F);
    EXPECT_FLOAT_EQ(spot.light.radius, 0.5F);
}

TEST(SceneLoader, ReadsModels) {
    const auto scene = good_parts("g.model { name = 'floor', shape = 'plane', size = {40, 30}, "
                                  "color = {0.1, 0.2, 0.3}, casts = false, "
                                  "receives = false, hero = true, scale = 2, position = {1, 2, 3}, "
                                  "shadow = { error_px = 0.25 } }, "
                                  "g.model { file = 'models/fox.glb', animation = 'Run', "
                                  "animation_speed = 0.5, scale = {1, -1, 1} }");

    ASSERT_EQ(scene.models.size(), 2U);
    const scene::ModelDescription& floor = scene.models[0];
    EXPECT_EQ(floor.shape, "plane");
    expect_near(floor.size, {40.0F, 1.0F, 30.0F});
    expect_near(glm::vec3(*floor.color), {0.1F, 0.2F, 0.3F});
    EXPECT_FALSE(floor.casts);
    EXPECT_FALSE(floor.receives);
    EXPECT_TRUE(floor.hero);
    expect_near(floor.transform.scale, {2.0F, 2.0F, 2.0F});
    EXPECT_EQ(floor.shadow.error_px, 0.25F);
    EXPECT_EQ(scene.models[1].name, "fox");
    EXPECT_EQ(scene.models[1].animation, "Run");
    expect_near(scene.models[1].transform.scale, {1.0F, -1.0F, 1.0F});
}

TEST(SceneLoader, TurnsRollFirstThenPitchThenYaw) {
    const auto scene = good_parts("g.model { shape = 'box', rotation = {90, 90, 0} }");

    const glm::quat turn = scene.models.at(0).transform.rotation;
    expect_near(
        turn * glm::vec3(0.0F, 1.0F, 0.0F), {1.0F, 0.0F, 0.0F}); // pitch takes y to z, yaw z to x
}

TEST(SceneLoader, LooksWhereACameraShould) {
    const auto scene = good_parts(
        "g.camera { name = 'a', position = {0, 0, 5}, look_at = {0, 0, 9}, fov = 90, near = 0.5 }, "
        "g.camera { rotation = {0, 90, 0} }");

    expect_near(looks_along(scene.cameras.at(0).transform.rotation), {0.0F, 0.0F, 1.0F});
    EXPECT_FLOAT_EQ(scene.cameras[0].camera.fov_y, glm::radians(90.0F));
    EXPECT_FLOAT_EQ(scene.cameras[0].camera.near, 0.5F);
    expect_near(looks_along(scene.cameras.at(1).transform.rotation), {-1.0F, 0.0F, 0.0F});
}

TEST(SceneLoader, ReadsRulesInTheirOrder) {
    const auto scene =
        good_parts("g.spot { name = 'torch' }, g.model { name = 'floor', shape = 'box' }, "
                   "g.rule { light = 'torch', receiver = 'floor', technique = 'planar' }, "
                   "g.rule { caster = 'floor/lid', distance = 60, never = 'volume' }");

    ASSERT_EQ(scene.rules.size(), 2U);
    EXPECT_EQ(scene.rules[0].light, "torch");
    EXPECT_EQ(scene.rules[0].receiver, "floor");
    EXPECT_EQ(scene.rules[0].shadow.technique, "planar");
    EXPECT_EQ(scene.rules[1].caster, "floor/lid");
    EXPECT_EQ(scene.rules[1].distance, 60.0F);
    EXPECT_EQ(scene.rules[1].shadow.never, std::vector<std::string>{"volume"});
}

TEST(SceneLoader, ReadsTheFieldsOfTheScene) {
    const auto scene = good_parts("budget = { error_px = 0.5, shadow_ms = 8 }, ambient = {0, 0.5, "
                                  "1}, exposure = 0.25, shadow = { filter = 'pcf' }");

    EXPECT_EQ(scene.shadow.error_px, 0.5F);
    EXPECT_EQ(scene.shadow.filter, "pcf");
    EXPECT_EQ(scene.shadow_ms, 8.0F);
    EXPECT_EQ(scene.exposure, 0.25F);
    expect_near(scene.ambient, {0.0F, 0.5F, 1.0F});
}

TEST(SceneLoader, UnfoldsListsAndMakesUpNames) {
    const auto scene =
        good("local boxes = {}\nfor i = 1, 3 do boxes[i] = g.model { shape = 'box' } end\n"
             "return g.scene { { boxes, {} }, g.model { name = 'box_2', shape = 'cone' } }");

    std::vector<std::string> names;
    for (const scene::ModelDescription& model : scene.models)
        names.push_back(model.name);
    EXPECT_THAT(names, ElementsAre("box", "box_3", "box_4", "box_2"));
}

TEST(SceneLoader, ConvertsWebColours) {
    const auto scene =
        good_parts("g.sun { color = g.srgb('#ff8000') }, g.lamp { color = g.srgb(255, 255, 0) }");

    expect_near(scene.lights.at(0).light.color, {1.0F, 0.2158605F, 0.0F});
    expect_near(scene.lights.at(1).light.color, {1.0F, 1.0F, 0.0F});
}

TEST(SceneLoader, WarnsOfPartsThatWereForgotten) {
    const LoadedScene loaded =
        testing::load("local lost = g.sun { name = 'lost' }\nreturn g.scene {}");

    EXPECT_THAT(
        loaded.warnings, ElementsAre("yard.lua:2: sun: is made, but it is not in the scene"));
    EXPECT_TRUE(loaded.scene.has_value());
}

TEST(SceneLoader, ReadsAFileThatStartsWithAByteOrderMark) {
    EXPECT_TRUE(
        load_scene_text("\xEF\xBB\xBFreturn require 'gnomon'.scene {}", "a.lua", testing::words())
            .scene.has_value());
}

TEST(SceneLoader, LoadsTheSampleLevelWithoutAWarning) {
    const LoadedScene loaded =
        load_scene(fs::path(PROJECT_SOURCE_DIR) / "games/sample/level.lua", testing::words());

    EXPECT_TRUE(loaded.scene.has_value()) << loaded.error_text();
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_GT(loaded.scene->models.size(), 50U);
}

/// A folder of its own with a level in it.
class LevelFolder : public ::testing::Test {
protected:
    LevelFolder()
        : root_(
            fs::temp_directory_path()
            / ("gnomon_"
               + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))),
          folder_(root_ / "levels") {
        fs::remove_all(root_);
        fs::create_directories(folder_ / "parts");
    }
    ~LevelFolder() override { fs::remove_all(root_); }
    LevelFolder(const LevelFolder&) = delete;
    LevelFolder& operator=(const LevelFolder&) = delete;

    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file) << text;
    }

    LoadedScene load(const std::string& text) {
        write(folder_ / "yard.lua", "local g = require 'gnomon'\n" + text);
        return load_scene(folder_ / "yard.lua", testing::words());
    }

    std::string mistake(const std::string& text) {
        const LoadedScene loaded = load(text);
        return loaded.errors.empty() ? "" : engine::to_string(loaded.errors.front());
    }

    fs::path root_;
    fs::path folder_;
};

using Require = LevelFolder;

TEST_F(Require, FindsModulesOfTheLevelAndListsTheirFiles) {
    write(
        folder_ / "parts/walls.lua",
        "local g = require 'gnomon'\nreturn { g.model { name = 'wall', shape = 'box' } }");

    const LoadedScene loaded = load("return g.scene { require 'parts.walls' }");

    ASSERT_TRUE(loaded.scene.has_value()) << loaded.error_text();
    EXPECT_EQ(loaded.scene->models.at(0).name, "wall");
    EXPECT_THAT(loaded.files, ElementsAre(folder_ / "yard.lua", folder_ / "parts/walls.lua"));
}

TEST_F(Require, NamesTheModuleWhereTheMistakeIs) {
    write(
        folder_ / "walls.lua",
        "local g = require 'gnomon'\nreturn { g.model {\n shape = 'bux' } }");

    EXPECT_THAT(
        mistake("return g.scene { require 'walls' }"),
        HasSubstr("walls.lua:3: model: shape is \"bux\""));
}

TEST_F(Require, NamesTheLineOfASyntaxErrorInAModule) {
    write(folder_ / "walls.lua", "return {\n\n+ }");

    EXPECT_THAT(
        mistake("return g.scene { require 'walls' }"),
        HasSubstr("walls.lua:3: unexpected symbol near '+'"));
}

TEST_F(Require, RefusesNamesThatCouldLeaveTheFolder) {
    for (const char* name :
         {"../secret", "/etc/passwd", "..secret", "a..b", ".a", "a.", "", "a/b", "a\\\\b", "a b"}) {
        SCOPED_TRACE(name);
        EXPECT_THAT(
            mistake(std::string("require \"") + name + "\""), HasSubstr("is no module name"));
    }
}

TEST_F(Require, RefusesLinksThatLeadOut) {
    write(root_ / "secret.lua", "return 1");
    fs::create_symlink(root_ / "secret.lua", folder_ / "inside.lua");

    EXPECT_THAT(
        mistake("require 'inside'"),
        HasSubstr("yard.lua:2: module 'inside' is a link that leads out of"));
}

TEST_F(Require, RefusesLinkedFoldersThatLeadOut) {
    fs::create_directories(root_ / "levels_of_others");
    write(root_ / "levels_of_others/secret.lua", "return 1");
    fs::create_directory_symlink(root_ / "levels_of_others", folder_ / "others");

    EXPECT_THAT(mistake("require 'others.secret'"), HasSubstr("is a link that leads out of"));
}

TEST_F(Require, NamesAModuleThatIsNotThere) {
    EXPECT_THAT(
        mistake("\nrequire 'nowhere'"),
        HasSubstr("yard.lua:3: no module 'nowhere': there is no file"));
}

TEST_F(Require, NoticesARing) {
    write(folder_ / "a.lua", "return require 'b'");
    write(folder_ / "b.lua", "return require 'a'");

    EXPECT_THAT(mistake("require 'a'"), HasSubstr("b.lua:1: module 'a' requires itself"));
}

TEST_F(Require, RunsAModuleOnce) {
    write(folder_ / "a.lua", "print 'once' return {}");

    EXPECT_THAT(load("require 'a' require 'a' return g.scene {}").output, ElementsAre("once"));
}

TEST_F(Require, WantsAModuleToReturnSomething) {
    write(folder_ / "a.lua", "local x = 1");

    EXPECT_THAT(mistake("require 'a'"), HasSubstr("module 'a' returns nothing; expected a table"));
}

using Files = LevelFolder;

TEST_F(Files, OfModelsMustBeThere) {
    const std::string text =
        mistake("return g.scene { g.model { name = 'hero',\n file = 'hero.glb' } }");

    EXPECT_THAT(
        text, HasSubstr("yard.lua:3: model \"hero\": file is \"hero.glb\", but there is no file "));
    EXPECT_THAT(text, HasSubstr((folder_ / "hero.glb").generic_string()));
}

TEST_F(Files, OfModelsAreRelativeToTheLevel) {
    write(folder_ / "hero.glb", "");

    EXPECT_TRUE(load("return g.scene { g.model { file = 'hero.glb' } }").scene.has_value());
}

TEST_F(Files, ThatAreMissingOrNoFilesAreRefused) {
    EXPECT_THAT(
        load_scene(folder_ / "none.lua", testing::words()).error_text(),
        HasSubstr("none.lua: no such file"));
    EXPECT_THAT(
        load_scene(folder_, testing::words()).error_text(), HasSubstr("this is not a file"));
}

TEST_F(Files, WithLongPathsAreStillNamedWhole) {
    const fs::path deep = folder_ / std::string(60, 'a') / std::string(60, 'b');
    fs::create_directories(deep);
    write(deep / "yard.lua", "\nerror 'here'");

    const LoadedScene loaded = load_scene(deep / "yard.lua", testing::words());

    ASSERT_EQ(loaded.errors.size(), 1U);
    EXPECT_EQ(loaded.errors[0].place.file, (deep / "yard.lua").generic_string());
    EXPECT_EQ(loaded.errors[0].place.line, 2);
    EXPECT_EQ(loaded.errors[0].message, "here");
}

} // namespace

} // namespace script
