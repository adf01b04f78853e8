// Levels that act: what on_update sees and changes, and what becomes of its mistakes.

#include "engine/scene/framing.hpp"
#include "engine/scene/scene_builder.hpp"
#include "engine/script/live_fields.hpp"
#include "tests/engine/script/levels.hpp"

#include <gmock/gmock.h>

namespace script {

namespace {

using ::testing::HasSubstr;

constexpr const char* kParts = R"(
  g.sun { name = "sun", direction = {0, -1, 0}, illuminance = 500 },
  g.spot { name = "torch", position = {1, 2, 3} },
  g.lamp { name = "lamp" },
  g.camera { name = "eye", position = {0, 1, 5} },
  g.model { name = "box", shape = "box", position = {4, 0, 0} },
)";

/// A level at work.
struct Running {
    std::unique_ptr<LevelScript> script;
    scene::World world;

    engine::Result<void> update(float dt = 0.5F) { return script->update(world, dt); }
    template <class Component>
    const Component& get(const std::string& name) {
        ecs::Entity found;
        world.registry.each<scene::Name, Component>(
            [&](ecs::Entity entity, const scene::Name& its, const auto& /*component*/) {
                if (its.text == name) found = entity;
            });
        return world.registry.get<Component>(found);
    }
};

/// @param body of on_update, from line 4 on
std::unique_ptr<Running> run(const std::string& body, const std::string& before = "") {
    LoadedScene loaded = testing::load(
        "local world = g.world " + before + "\nreturn g.scene { on_update = function(dt)\n" + body
        + "\nend," + kParts + "}");
    EXPECT_TRUE(loaded.scene.has_value()) << loaded.error_text();
    EXPECT_TRUE(loaded.script != nullptr);
    auto running = std::make_unique<Running>();
    running->script = std::move(loaded.script);
    EXPECT_TRUE(scene::build_world(*loaded.scene, {}, running->world));
    return running;
}

TEST(LevelScript, ReadsAndSetsWhatHasAName) {
    const auto level = run(R"(
        local sun, torch = world:find("sun"), world:find("torch")
        sun.direction = { 1, 0, 0 }
        sun.illuminance = sun.illuminance * 2
        torch.position = { torch.position[1] + dt, 2, world.time }
        torch.on = not torch.on
        torch.color = { 1, 0.5, 0 }
        world:find("eye").rotation = { 0, 90, 0 }
        world:find("box").position = { 0, 7, 0 }
    )");

    const auto done = level->update();
    const auto again = level->update();

    ASSERT_TRUE(done) << done.error().message;
    ASSERT_TRUE(again);
    EXPECT_NEAR(
        glm::dot(
            level->get<scene::Transform>("sun").rotation * glm::vec3(0, 0, -1), glm::vec3(1, 0, 0)),
        1.0F,
        1e-5F);
    EXPECT_FLOAT_EQ(level->get<scene::Light>("sun").intensity, 2000.0F);
    EXPECT_EQ(level->get<scene::Transform>("torch").position, glm::dvec3(2.0, 2.0, 1.0));
    EXPECT_TRUE(level->get<scene::Light>("torch").on);
    EXPECT_EQ(level->get<scene::Light>("torch").color, glm::vec3(1.0F, 0.5F, 0.0F));
    EXPECT_EQ(level->get<scene::Transform>("box").position, glm::dvec3(0.0, 7.0, 0.0));
    const glm::vec3 looks =
        level->get<scene::Transform>("eye").rotation * glm::vec3(0.0F, 0.0F, -1.0F);
    EXPECT_NEAR(looks.x, -1.0F, 1e-5F);
}

TEST(LevelScript, WithoutOnUpdateNothingIsKept) {
    EXPECT_EQ(testing::load_parts(kParts).script, nullptr);
}

TEST(LevelScript, EveryLiveFieldReadsBackWhatWasSet) {
    const auto level = run("");
    for (const LiveField& field : live_fields()) {
        SCOPED_TRACE(std::string(field.kind) + "." + std::string(field.field));
        const std::map<std::string_view, std::string> names = {
            {"sun", "sun"},
            {"spot", "torch"},
            {"lamp", "lamp"},
            {"camera", "eye"},
            {"model", "box"}};
        ecs::Entity entity;
        level->world.registry.each<scene::Name>([&](ecs::Entity one, const scene::Name& name) {
            if (name.text == names.at(field.kind)) entity = one;
        });
        if (field.field == "path_speed") level->world.registry.add(entity, scene::PathFollower{});
        if (field.field == "animation_speed")
            level->world.registry.add(entity, scene::AnimationPlayer{});
        EXPECT_EQ(live_kind(level->world, entity), field.kind);

        LiveValue value = field.read(level->world, entity);
        if (auto* truth = std::get_if<bool>(&value)) *truth = !*truth;
        if (auto* number = std::get_if<double>(&value)) *number = 2.5;
        if (auto* vector = std::get_if<glm::dvec3>(&value)) *vector = {0.6, 0.0, -0.8};
        field.write(level->world, entity, value);
        const LiveValue back = field.read(level->world, entity);

        ASSERT_EQ(back.index(), value.index());
        if (const auto* vector = std::get_if<glm::dvec3>(&value)) {
            EXPECT_LT(glm::length(std::get<glm::dvec3>(back) - *vector), 1e-5);
        } else {
            EXPECT_EQ(back, value);
        }
    }
}

TEST(LevelScript, EveryLiveFieldIsInTheSchema) {
    const engine::Schema schema = scene_schema(testing::words());
    for (const LiveField& live : live_fields()) {
        SCOPED_TRACE(live.field);
        const engine::Field* field = schema.kind(live.kind).find(live.field);
        ASSERT_NE(field, nullptr);
        EXPECT_TRUE(field->live);
        const bool is_vector = field->min_count == 3 && field->type == engine::FieldType::vector;
        EXPECT_TRUE(is_vector || field->fallback.index() != 0U) << "readers want a default";
    }
}

TEST(LevelScript, AMistakeIsToldOnceWithItsTraceback) {
    const auto level =
        run("  count()",
            "local calls = 0 local function count() calls = calls + 1 "
            "if calls == 2 then error('no more') end "
            "world:find('box').position = {calls, 0, 0} end");

    EXPECT_TRUE(level->update());
    const auto failed = level->update();
    const auto after = level->update();

    ASSERT_FALSE(failed);
    EXPECT_THAT(engine::to_string(failed.error()), HasSubstr("yard.lua:2: no more"));
    EXPECT_THAT(failed.error().message, HasSubstr("stack traceback"));
    EXPECT_THAT(failed.error().message, HasSubstr("yard.lua:4"));
    EXPECT_TRUE(after) << "told once";
    EXPECT_EQ(level->get<scene::Transform>("box").position.x, 1.0) << "and not called again";
}

/// Bodies that fail, and what is said.
struct Mistake {
    const char* name;
    const char* body;
    const char* message;
};

class LevelScriptMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(LevelScriptMistakes, AreToldWithTheirLine) {
    const auto level = run(GetParam().body);

    const auto failed = level->update();

    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().message, HasSubstr(GetParam().message));
    EXPECT_EQ(failed.error().place.line, 4);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    LevelScriptMistakes,
    ::testing::Values(
        Mistake{"UnknownName", "world:find('snu')", "did you mean 'sun'?"},
        Mistake{
            "UnknownField", "world:find('sun').directon = {0, -1, 0}", "did you mean 'direction'?"},
        Mistake{
            "FieldOfAnotherKind", "world:find('sun').position = {0, 1, 0}", "has no 'position'"},
        Mistake{"WrongType", "world:find('sun').on = 1", "on is 1, expected true or false"},
        Mistake{"OutOfRange", "world:find('sun').illuminance = -1", "expected 0 to 1000000"},
        Mistake{"NotANumber", "world:find('box').position = {0, 0/0, 0}", "position is"},
        Mistake{"TooShort", "world:find('box').position = {0, 1}", "has 2 values"},
        Mistake{"NoLength", "world:find('sun').direction = {0, 0, 0}", "has no length"},
        Mistake{
            "ATableInItself",
            "local t = {} t[1] = t world:find('box').position = t",
            "nested too deep"},
        Mistake{"FindWithADot", "world.find('sun')", "world:find(\"name\")"},
        Mistake{"UnknownWord", "local x = world.tiem", "it has find, time"},
        Mistake{"SettingTime", "world.time = 3", "cannot be set"},
        Mistake{"AnEndlessLoop", "while true do end", "endless loop"}),
    [](const auto& param) { return param.param.name; });

TEST(LevelScript, AMemoryBombIsDefused) {
    const auto level = run("local text = 'x' while true do text = text .. text end");

    const auto failed = level->update();

    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().message, HasSubstr("more than 64 MiB"));
}

TEST(LevelScript, TheWorldIsNotThereWhileTheLevelIsRead) {
    const LoadedScene loaded = testing::load("g.world:find('sun') return g.scene {}");

    ASSERT_FALSE(loaded.scene);
    EXPECT_THAT(loaded.error_text(), HasSubstr("while the level runs"));
}

TEST(LevelScript, OnUpdateMustBeAFunction) {
    const LoadedScene loaded = testing::load_parts("on_update = 3");

    ASSERT_FALSE(loaded.scene);
    EXPECT_THAT(loaded.error_text(), HasSubstr("on_update is 3, expected a function"));
}

TEST(LevelScript, RunsTheSameEveryTime) {
    const auto positions = [] {
        const auto level =
            run("world:find('box').position = {math.random(), math.sin(world.time), 0}");
        std::vector<glm::dvec3> seen;
        for (int i = 0; i < 20; ++i) {
            EXPECT_TRUE(level->update(0.016F));
            seen.push_back(level->get<scene::Transform>("box").position);
        }
        return seen;
    };

    EXPECT_EQ(positions(), positions());
}

TEST(LevelScript, MemoryDoesNotGrowOverManyCalls) {
    const auto level = run("local t = {} for i = 1, 2000 do t[i] = { i } end "
                           "world:find('box').position = { #t, 0, 0 }");

    for (int i = 0; i < 1500; ++i) { // far more than the cap if nothing were collected
        const auto done = level->update(0.016F);
        ASSERT_TRUE(done) << i << done.error().message;
    }
}

TEST(LevelScript, PrintsEachLineOnce) {
    const auto level = run("print(world.time)");

    EXPECT_TRUE(level->update());
    EXPECT_EQ(level->script->take_output(), std::vector<std::string>{"0.5"});
    EXPECT_TRUE(level->script->take_output().empty());
}

TEST(Presets, AreThoseOfTheSchemaAndFillInWhatIsNotSaid) {
    const engine::Schema schema = scene_schema(testing::words());
    for (const std::string& preset : schema.kind("scene").find("preset")->words) {
        SCOPED_TRACE(preset);
        const LoadedScene loaded = testing::load_parts(
            "preset = '" + preset + "', shadow = { samples = 7 }, budget = { error_px = 3 }");
        ASSERT_TRUE(loaded.scene) << loaded.error_text();
        EXPECT_EQ(loaded.scene->shadow.samples, 7);
        EXPECT_EQ(loaded.scene->shadow.error_px, 3.0F);
        EXPECT_TRUE(loaded.scene->shadow.map_size.has_value());
        EXPECT_TRUE(loaded.scene->shadow.filter.has_value());
    }
}

TEST(Presets, AWrongOneIsToldWithTheNearest) {
    const LoadedScene loaded = testing::load_parts("preset = 'hihg'");

    ASSERT_FALSE(loaded.scene);
    EXPECT_THAT(loaded.error_text(), HasSubstr("yard.lua:2"));
    EXPECT_THAT(loaded.error_text(), HasSubstr("did you mean 'high'?"));
}

TEST(Paths, AreReadAndFollowed) {
    const LoadedScene loaded = testing::load_parts(
        "g.path { name = 'round', points = {{0,0,0}, {4,0,0}, {4,0,4}}, closed = false }, "
        "g.model { name = 'box', shape = 'box', path = 'round', path_speed = 2, path_start = 0.25 "
        "}, "
        "g.player { position = {1, 2, 3}, heading = 90, speed = 2, path = 'round' }");
    ASSERT_TRUE(loaded.scene) << loaded.error_text();
    scene::World world;
    ASSERT_TRUE(scene::build_world(*loaded.scene, {}, world));

    ASSERT_EQ(world.assets.paths.size(), 1U);
    EXPECT_EQ(scene::period(world.assets.paths[0]), 16.0);
    EXPECT_EQ(loaded.scene->player->path, "round");
    EXPECT_EQ(loaded.scene->player->position, glm::dvec3(1.0, 2.0, 3.0));
    const auto place = [&] {
        return world.registry
            .get<scene::Transform>(*world.registry.view<scene::PathFollower>().begin())
            .position;
    };
    EXPECT_EQ(place(), glm::dvec3(4.0, 0.0, 0.0));
    scene::update(world, 1.0F);
    EXPECT_EQ(place(), glm::dvec3(4.0, 0.0, 2.0));
    scene::update(world, 2.0F);
    EXPECT_EQ(place(), glm::dvec3(4.0, 0.0, 2.0)) << "on the way back";
}

TEST(Paths, MistakesAreTold) {
    const auto error = [](const std::string& parts) {
        return testing::load_parts(parts).error_text();
    };

    EXPECT_THAT(error("g.path { points = {{0,0,0}} }"), HasSubstr("a list of 2 or more places"));
    EXPECT_THAT(
        error("g.path { points = {{0,0,0}, {1,2}} }"), HasSubstr("a list of 2 or more places"));
    EXPECT_THAT(error("g.path { points = {{1,0,0}, {1,0,0}} }"), HasSubstr("all the same place"));
    EXPECT_THAT(error("g.path { name = 'p' }"), HasSubstr("missing"));
    EXPECT_THAT(
        error("g.model { shape = 'box', path = 'nowhere' }"), HasSubstr("no path of this level"));
    EXPECT_THAT(
        error("g.path { name = 'p', points = {{0,0,0}, {1,0,0}} }, "
              "g.model { shape = 'box', path = 'p', position = {0, 0, 0} }"),
        HasSubstr("position is said besides path"));
    EXPECT_THAT(error("g.player {}, g.player {}"), HasSubstr("second one"));
    EXPECT_THAT(error("g.player { path = 'nowhere' }"), HasSubstr("no path of this level"));
}

} // namespace

} // namespace script
