// Every mistake that a designer can make, and the sentence that they read. Places count from the
// line of `local g = require "gnomon"`, which is 1.

#include "tests/engine/script/levels.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace script {

namespace {

using ::testing::HasSubstr;

struct BrokenLevel {
    const char* name;
    const char* text; ///< after the line that makes g
    std::vector<std::string>
        messages; ///< parts of the errors, in their order; exactly as many errors
};

std::ostream& operator<<(std::ostream& out, const BrokenLevel& level) {
    return out << level.name;
}

class BrokenLevels : public ::testing::TestWithParam<BrokenLevel> {};

TEST_P(BrokenLevels, AreRefusedWithAllTheirMistakes) {
    const LoadedScene loaded = testing::load(GetParam().text);

    EXPECT_FALSE(loaded.scene.has_value());
    ASSERT_EQ(loaded.errors.size(), GetParam().messages.size()) << loaded.error_text();
    for (std::size_t i = 0; i < loaded.errors.size(); ++i)
        EXPECT_THAT(engine::to_string(loaded.errors[i]), HasSubstr(GetParam().messages[i]));
}

const std::vector<BrokenLevel> kFields = {
    {"UnknownField",
     "return g.scene {\n  g.sun { name = \"sun\",\n    shadow = { technique = \"auto\",\n      "
     "cascade_cout = 4 } } }",
     {R"(yard.lua:5: sun "sun": shadow.cascade_cout is no field; did you mean 'cascades'?)"}},
    {"MisspeltField",
     "return g.scene { g.lamp { name = \"a\", raduis = 1 } }",
     {R"(yard.lua:2: lamp "a": raduis is no field; did you mean 'radius'?)"}},
    {"FarField",
     "return g.scene { g.sun { hello_world = 1 } }",
     {"hello_world is no field; the fields are name, direction"}},
    {"SceneField",
     "return g.scene { budgets = {} }",
     {"scene: budgets is no field; did you mean 'budget'?"}},
    {"StrayKey",
     "return g.scene { g.sun { [2.5] = 1 } }",
     {"sun: [2.5] is no field; fields have names"}},
    {"BooleanKey", "return g.scene { g.sun { [true] = 1 } }", {"sun: [true] is no field"}},
    {"Positional",
     "return g.scene { g.sun { \"noon\" } }",
     {R"(sun: has a value without a name, "noon")"}},
    {"ManyAtOnce",
     "return g.scene {\n  g.sun { angular_size = -1 },\n  g.spot { outer_angle = 100 },\n  g.model "
     "{ },\n}",
     {"yard.lua:3: sun: angular_size",
      "yard.lua:4: spot: outer_angle",
      "yard.lua:5: model: has neither"}},
    {"LineOfTheField",
     "return g.scene {\n  g.sun {\n    name = \"s\",\n    -- illuminance = 1,\n    illuminance = "
     "-1,\n  },\n}",
     {"yard.lua:6: sun \"s\": illuminance is -1 lux, expected 0 to 1000000 lux"}},
    {"SecondOnTheLine",
     "return g.scene { g.sun { name = \"a\" }, g.sun { name = \"b\",\n on = 1 } }",
     {"yard.lua:3: sun \"b\": on is 1, expected true or false"}},
    {"KeyInQuotes",
     "return g.scene { g.lamp {\n [\"radius\"] = -1 } }",
     {"yard.lua:3: lamp: radius is -1 m, expected 0 to 100 m"}}};

const std::vector<BrokenLevel> kTypes = {
    {"NumberInQuotes",
     "return g.scene { g.lamp { radius = \"5\" } }",
     {"radius is \"5\", expected a number; write it without quotes"}},
    {"WordForNumber",
     "return g.scene { g.lamp { radius = \"big\" } }",
     {"radius is \"big\", expected a number"}},
    {"BooleanForNumber",
     "return g.scene { g.lamp { range = true } }",
     {"range is true, expected a number"}},
    {"FunctionForNumber",
     "return g.scene { g.lamp { range = print } }",
     {"range is a function, expected a number"}},
    {"NumberForBoolean",
     "return g.scene { g.model { shape = \"box\", casts = 1 } }",
     {"casts is 1, expected true or false"}},
    {"NumberForName", "return g.scene { g.sun { name = 7 } }", {"name is 7, expected a name"}},
    {"NumberForTable",
     "return g.scene { g.sun { shadow = 3 } }",
     {"shadow is 3, expected a table"}},
    {"WordForVector",
     "return g.scene { g.lamp { position = \"here\" } }",
     {"position is \"here\", expected a list of 3 numbers"}},
    {"ShortVector",
     "return g.scene { g.lamp { position = {1, 2} } }",
     {"position has 2 values, expected a list of 3 numbers"}},
    {"LongVector",
     "return g.scene { g.lamp { position = {1, 2, 3, 4} } }",
     {"position has 4 values"}},
    {"NamedVector",
     "return g.scene { g.lamp { position = {x = 1, y = 2, z = 3} } }",
     {"position has a field 'x', expected a list of 3"}},
    {"HoleInVector",
     "return g.scene { g.lamp { position = {1, nil, 3} } }",
     {"position has 2 values"}},
    {"TextInVector",
     "return g.scene { g.lamp { position = {1, \"2\", 3} } }",
     {"position is \"2\", expected a list of 3 numbers"}},
    {"TwoSizesForABox",
     "return g.scene { g.model { shape = \"box\", size = {1, 2} } }",
     {"size has 2 values, expected 3 for a box"}},
    {"HalfMapSize",
     "return g.scene { g.sun { shadow = { map_size = 512.5 } } }",
     {"shadow.map_size is 512.5, expected a whole number"}},
    {"NeverAsNumber",
     "return g.scene { g.rule { never = 1 } }",
     {"never is 1, expected one or a list of"}},
    {"NeverWithNames",
     "return g.scene { g.rule { never = { volume = true } } }",
     {"never has named fields, expected a list of words"}}};

const std::vector<BrokenLevel> kRanges = {
    {"NotANumber", "return g.scene { g.lamp { intensity = 0/0 } }", {"intensity is "}},
    {"Infinity",
     "return g.scene { g.lamp { intensity = math.huge } }",
     {"intensity is inf, expected 0 to 100000000 cd"}},
    {"InfinityInVector",
     "return g.scene { g.lamp { position = {0, -1/0, 0} } }",
     {"position is -inf, expected -10000000 to 10000000 m"}},
    {"NegativeRange",
     "return g.scene { g.lamp { range = 0 } }",
     {"range is 0 m, expected more than 0 and at most 1000000 m"}},
    {"FlatSpot",
     "return g.scene { g.spot { outer_angle = 90 } }",
     {"outer_angle is 90 deg, expected more than 0 and less than 90 deg"}},
    {"InnerOverOuter",
     "return g.scene { g.spot { inner_angle = 50, outer_angle = 40 } }",
     {"inner_angle is not less than outer_angle"}},
    {"WideCamera",
     "return g.scene { g.camera { fov = 180 } }",
     {"fov is 180 deg, expected 1 to 170 deg"}},
    {"NearAtZero", "return g.scene { g.camera { near = 0 } }", {"near is 0 m, expected"}},
    {"FiveCascades",
     "return g.scene { g.sun { shadow = { cascades = 5 } } }",
     {"shadow.cascades is 5, expected 1 to 4"}},
    {"HugeMap",
     "return g.scene { g.sun { shadow = { map_size = 1e9 } } }",
     {"shadow.map_size is 1000000000 texels, expected 16 to 16384 texels"}},
    {"NegativeError",
     "return g.scene { budget = { error_px = -1 } }",
     {"scene: budget.error_px is -1 px, expected 0 to 1000 px"}},
    {"FreeFrame",
     "return g.scene { budget = { shadow_ms = 0 } }",
     {"budget.shadow_ms is 0 ms, expected more than 0"}},
    {"BrightShape",
     "return g.scene { g.model { shape = \"box\", color = {2, 0, 0} } }",
     {"color is 2, expected 0 to 1"}},
    {"FlatScale",
     "return g.scene { g.model { shape = \"box\", scale = {1, 0, 1} } }",
     {"scale has a factor 0"}},
    {"EmptySize",
     "return g.scene { g.model { shape = \"box\", size = {1, 0, 1} } }",
     {"size is 0 m, expected more than 0"}},
    {"FatTorus",
     "return g.scene { g.model { shape = \"torus\", size = {1, 1, 1} } }",
     {"the torus has no hole"}},
    {"FarAway",
     "return g.scene { g.model { shape = \"box\", position = {1e9, 0, 0} } }",
     {"position is 1000000000 m, expected"}},
    {"NoDirection",
     "return g.scene { g.sun { direction = {0, 0, 0} } }",
     {"direction has no length"}},
    {"TargetAtPosition",
     "return g.scene { g.spot { position = {1, 1, 1}, target = {1, 1, 1} } }",
     {"target is the position itself"}},
    {"CameraAtItsTarget",
     "return g.scene { g.camera { position = {1, 1, 1}, look_at = {1, 1, 1} } }",
     {"look_at is the position itself"}}};

const std::vector<BrokenLevel> kMeaning = {
    {"WrongTechnique",
     "return g.scene { g.spot { shadow = { technique = \"volumes\" } } }",
     {
         "shadow.technique is \"volumes\", expected one of \"auto\", \"none\"",
     }},
    {"WrongFilter",
     "return g.scene { g.sun { shadow = { filter = \"pfc\" } } }",
     {"; did you mean 'pcf'?"}},
    {"WrongShape",
     "return g.scene { g.model { shape = \"cube\" } }",
     {"shape is \"cube\", expected one of \"box\""}},
    {"WrongNever",
     "return g.scene { g.rule { never = { \"volume\", \"plan\" } } }",
     {"never is \"plan\", expected one or a list of"}},
    {"NeverAuto", "return g.scene { g.rule { never = \"auto\" } }", {"never is \"auto\""}},
    {"AskedAndForbidden",
     "return g.scene { g.rule { technique = \"blob\", never = { \"blob\" } } }",
     {"never names \"blob\", which technique asks for"}},
    {"FileAndShape",
     "return g.scene { g.model { file = \"a.glb\", shape = \"box\" } }",
     {"has both a file and a shape"}},
    {"SizeOfAFile",
     "return g.scene { g.model { file = \"a.glb\", size = {1, 1, 1} } }",
     {"size is for shapes"}},
    {"ColorOfAFile",
     "return g.scene { g.model { file = \"a.glb\", color = {1, 1, 1} } }",
     {"color is for shapes"}},
    {"AnimatedShape",
     "return g.scene { g.model { shape = \"box\", animation = \"walk\" } }",
     {"animation is for files"}},
    {"NoModelFile",
     "return g.scene { g.model { file = \"a.obj\" } }",
     {"file is \"a.obj\", expected a .glb or .gltf file"}},
    {"AbsoluteFile",
     "return g.scene { g.model { file = \"/tmp/a.glb\" } }",
     {"expected a path relative to the level"}},
    {"DirectionAndTarget",
     "return g.scene { g.spot { direction = {0, -1, 0}, target = {0, 0, 0} } }",
     {"target is said besides direction"}},
    {"RotationAndLookAt",
     "return g.scene { g.camera { rotation = {0, 0, 0}, look_at = {0, 0, 0} } }",
     {"rotation is said besides look_at"}},
    {"ErrorTwice",
     "return g.scene { budget = { error_px = 1 }, shadow = { error_px = 2 } }",
     {"budget.error_px is said in shadow too"}},
    {"CascadesOfALamp",
     "return g.scene { g.lamp { shadow = { cascades = 2 } } }",
     {"shadow.cascades is for suns"}},
    {"SameNameTwice",
     "return g.scene { g.sun { name = \"a\" },\n g.model { name = \"a\", shape = \"box\" } }",
     {R"(yard.lua:3: model "a": name is taken by the light at yard.lua:2)"}},
    {"NameWithSlash",
     "return g.scene { g.sun { name = \"a/b\" } }",
     {"name is \"a/b\", expected a name"}},
    {"EmptyName", "return g.scene { g.sun { name = \"\" } }", {"name is \"\", expected a name"}},
    {"RuleForNoLight",
     "return g.scene { g.spot { name = \"torch\" }, g.rule { light = \"torhc\", technique = "
     "\"auto\" } }",
     {"rule: light is \"torhc\", which is no light of this level; did you mean 'torch'?"}},
    {"RuleForNoReceiver",
     "return g.scene { g.model { name = \"floor\", shape = \"box\" }, g.rule { receiver = "
     "\"flor\", technique = \"auto\" } }",
     {"receiver is \"flor\", which is no model of this level; did you mean 'floor'?"}},
    {"RuleForNoNode",
     "return g.scene { g.model { name = \"hero\", shape = \"box\" }, g.rule { caster = "
     "\"heros/arm\", technique = \"auto\" } }",
     {"caster is \"heros/arm\", which is no model of this level; did you mean 'hero'?"}},
    {"RuleForALightAsReceiver",
     "return g.scene { g.sun { name = \"sun\" }, g.rule { receiver = \"sun\", technique = \"auto\" "
     "} }",
     {"receiver is \"sun\", which is a light, expected a model"}},
    {"RuleWithoutAWish", "return g.scene { g.rule { distance = 4 } }", {"rule: asks for nothing"}},
    {"PlainTableInside",
     "return g.scene { { file = \"a.glb\" } }",
     {"scene: holds a plain table with a field 'file', expected g.sun"}},
    {"NumberInside", "return g.scene { 5 }", {"scene: holds 5, expected g.sun"}},
    {"FalseInside", "return g.scene { false }", {"scene: holds false"}},
    {"SceneInside", "return g.scene { g.scene {} }", {"scene: stands inside another scene"}}};

const std::vector<BrokenLevel> kScripts = {
    {"NoReturn",
     "g.scene {}",
     {"yard.lua: the level returns nil, expected: return g.scene { ... }"}},
    {"ReturnsAWord", "return \"scene\"", {"the level returns \"scene\", expected"}},
    {"ReturnsASun", "return g.sun {}", {"the level returns a sun, expected"}},
    {"ReturnsAPlainTable", "return {}", {"the level returns a table, expected"}},
    {"UnknownWord",
     "return g.scene { g.ligth { name = \"a\" },\n g.sun { on = 2 } }",
     {"yard.lua:2: 'ligth' is no word of gnomon", "yard.lua:3: sun: on is 2"}},
    {"NearWord",
     "return g.scene { g.modle { name = \"a\" } }",
     {"'modle' is no word of gnomon; did you mean 'model'?"}},
    {"CalledWithAWord",
     "return g.scene { g.sun \"noon\" }",
     {"yard.lua:2: sun is called with a string, expected a table: g.sun { ... }"}},
    {"ChangedVocabulary",
     "g.moon = 5\nreturn g.scene {}",
     {"yard.lua:2: the vocabulary has no place for 'moon'"}},
    {"UnknownGlobal", "\nreturn g.scene { sun {} }", {"yard.lua:3: unknown name 'sun'"}},
    {"MisspeltGlobal", "prnt(1)", {"yard.lua:2: unknown name 'prnt'; did you mean 'print'?"}},
    {"AssignedGlobal",
     "\n\nradius = 5",
     {"yard.lua:4: 'radius' is assigned but not declared; write: local radius = ..."}},
    {"MissingBrace", "return g.scene {\n g.sun {\n", {"yard.lua:4: unexpected symbol near <eof>"}},
    {"MissingComma",
     "return g.scene {\n g.sun {}\n g.sun {} }",
     {"yard.lua:4: '}' expected (to close '{' at line 2) near 'g'"}},
    {"RaisedText", "error(\"no torches today\")", {"yard.lua:2: no torches today"}},
    {"RaisedTextWithoutPlace", "error(\"plain\", 0)", {"yard.lua:2: plain"}},
    {"RaisedTable", "error({})", {"yard.lua:2: the script raised a table, expected a string"}},
    {"RaisedNil", "error()", {"the script raised a nil"}},
    {"NilArithmetic",
     "local x\nreturn g.scene { g.lamp { range = x + 1 } }",
     {"yard.lua:3: attempt to perform arithmetic on a nil value (local 'x')"}},
    {"SelfContained",
     "local t = g.scene {}\nt[1] = t\nt[2] = {t}\nreturn t",
     {"nested too deep, or contain themselves"}},
    {"WrongColourText",
     "return g.scene { g.sun { color = g.srgb(\"red\") } }",
     {"yard.lua:2: srgb wants \"#rrggbb\""}}};

std::string name_of(const ::testing::TestParamInfo<BrokenLevel>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Fields, BrokenLevels, ::testing::ValuesIn(kFields), name_of);
INSTANTIATE_TEST_SUITE_P(Types, BrokenLevels, ::testing::ValuesIn(kTypes), name_of);
INSTANTIATE_TEST_SUITE_P(Ranges, BrokenLevels, ::testing::ValuesIn(kRanges), name_of);
INSTANTIATE_TEST_SUITE_P(Meaning, BrokenLevels, ::testing::ValuesIn(kMeaning), name_of);
INSTANTIATE_TEST_SUITE_P(Scripts, BrokenLevels, ::testing::ValuesIn(kScripts), name_of);

TEST(BrokenLevels, WithThousandsOfMistakesShowAHundred) {
    const LoadedScene loaded = testing::load("local parts = {}\nfor i = 1, 5000 do parts[i] = "
                                             "g.sun { on = 1 } end\nreturn g.scene { parts }");

    ASSERT_EQ(loaded.errors.size(), 100U);
    EXPECT_EQ(loaded.errors.back().message, "and 4901 more mistakes");
}

} // namespace

} // namespace script
