// What scripts may not do, and what they do alike on every machine.

#include "tests/engine/script/levels.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace script {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What a script prints.
std::vector<std::string> printed(const std::string& text) {
    const LoadedScene loaded = testing::load(text + "\nreturn g.scene {}");
    EXPECT_TRUE(loaded.errors.empty()) << loaded.error_text();
    return loaded.output;
}

/// The first mistake of a script that must end.
std::string mistake(const std::string& text, const LuaLimits& limits = {}) {
    const LoadedScene loaded = testing::load(text, limits);
    EXPECT_FALSE(loaded.scene.has_value());
    return loaded.errors.empty() ? "" : engine::to_string(loaded.errors.front());
}

const LuaLimits kSmall{.memory_bytes = 8U << 20U, .instructions = 2'000'000, .seconds = 8.0};

std::string plain_name(const ::testing::TestParamInfo<std::string>& name) {
    return name.param;
}

class LeftOut : public ::testing::TestWithParam<std::string> {};

TEST_P(LeftOut, NamesAreNamedAtTheirLine) {
    const std::string& name = GetParam();

    EXPECT_THAT(mistake("local x = " + name), HasSubstr("yard.lua:2: '" + name + "' is left out"));
}

INSTANTIATE_TEST_SUITE_P(
    Sandbox,
    LeftOut,
    ::testing::Values<std::string>(
        "io",
        "os",
        "debug",
        "package",
        "load",
        "loadstring",
        "dofile",
        "loadfile",
        "collectgarbage",
        "next",
        "_G"),
    plain_name);

TEST(Sandbox, HasNoDangerousMembers) {
    EXPECT_THAT(
        printed("print(string.dump, math.randomseed, coroutine.close)"),
        ElementsAre("nil\tnil\tnil"));
}

TEST(Sandbox, RefusesBytecode) {
    const LoadedScene loaded =
        load_scene_text("\x1bLua\x54\x00\x19\x93", "yard.lua", testing::words());

    ASSERT_EQ(loaded.errors.size(), 1U);
    EXPECT_EQ(
        engine::to_string(loaded.errors[0]), "yard.lua:1: this is bytecode, expected Lua text");
}

TEST(Sandbox, RefusesFinalizersBecauseNoLimitReachesThem) {
    EXPECT_THAT(
        mistake("setmetatable({}, { __gc = function() while true do end end })"),
        HasSubstr("yard.lua:2: finalizers (__gc) are left out"));
}

TEST(Sandbox, KeepsTheMetatablesOfStringsAndGlobals) {
    EXPECT_THAT(
        printed("print(getmetatable(\"\"), getmetatable(_ENV), pcall(setmetatable, _ENV, {}))"),
        ElementsAre(HasSubstr("false\tfalse\tfalse")));
}

TEST(Limits, StopAnEndlessLoopAtItsLine) {
    EXPECT_THAT(
        mistake("local n = 0\nwhile true do\n n = n + 1 end", kSmall),
        ::testing::AllOf(
            HasSubstr("yard.lua:"),
            HasSubstr("more than 2000000 instructions; is there an endless loop?")));
}

TEST(Limits, CannotBeCaught) {
    EXPECT_THAT(
        mistake("while true do pcall(function() while true do end end) end", kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldEvenWhenTheScriptEndsWellAfterwards) {
    EXPECT_THAT(
        mistake("pcall(function() while true do end end) return g.scene {}", kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldInCoroutines) {
    EXPECT_THAT(
        mistake("while true do coroutine.wrap(function() while true do end end)() end", kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldInCoroutinesThatArePolled) {
    EXPECT_THAT(
        mistake(
            "local c = coroutine.create(function() while true do coroutine.yield() end end)\n"
            "while true do coroutine.resume(c) end",
            kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldInErrorHandlers) {
    EXPECT_THAT(
        mistake("xpcall(error, function() while true do end end)", kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldInErrorHandlersOfTheLimitItself) {
    EXPECT_THAT(
        mistake(
            "xpcall(function() while true do end end, function() while true do end end)", kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldInVariablesThatCloseAfterALimit) {
    EXPECT_THAT(
        mistake(
            "local close = {__close = function() while true do end end}\n"
            "coroutine.wrap(function() local x <close> = setmetatable({}, close) while true do end "
            "end)()",
            kSmall),
        HasSubstr("instructions"));
}

TEST(Limits, HoldWhereErrorsTurnIntoText) {
    EXPECT_THAT(
        mistake("error(setmetatable({}, {__tostring = function() while true do end end}))", kSmall),
        HasSubstr("instructions"));
}

TEST(Sandbox, RunsProtectedCallsAndCoroutinesAsLuaDoes) {
    EXPECT_THAT(
        printed("print(xpcall(function(a, b) return a + b end, print, 1, 2))\n"
                "print(xpcall(error, function(m) return m .. \"!\" end, \"no\"))\n"
                "print(select(2, xpcall(error, function() error(\"again\", 0) end)))\n"
                "local step = coroutine.wrap(function(a) local b = coroutine.yield(a + 1) return b "
                "* 2, 7 end)\n"
                "print(step(1)) print(step(5)) print(pcall(step))\n"
                "print(pcall(coroutine.wrap(function() error(\"inside\", 0) end)))"),
        ElementsAre(
            "true\t3",
            "false\tno!",
            "again",
            "2",
            "10\t7",
            "false\tcannot resume dead coroutine",
            "false\tinside"));
}

TEST(Limits, HoldInMetamethods) {
    EXPECT_THAT(
        mistake(
            "local t = setmetatable({}, {__index = function(t, k) return t[k] end})\nreturn t.x",
            kSmall),
        HasSubstr("stack overflow"));
}

TEST(Limits, HoldForMemory) {
    EXPECT_THAT(
        mistake("local t = {}\nfor i = 1, 1e9 do t[i] = i end", kSmall),
        HasSubstr("yard.lua: the script wants more than 8 MiB of memory"));
}

TEST(Limits, HoldForMemoryOfOneString) {
    EXPECT_THAT(
        mistake("local s = (\"x\"):rep(1 << 25)", kSmall), HasSubstr("more than 8 MiB of memory"));
}

TEST(Limits, HoldForDoublingStrings) {
    EXPECT_THAT(
        mistake("local s = \"x\" while true do s = s .. s end", kSmall),
        HasSubstr("more than 8 MiB"));
}

struct Hang {
    const char* name;
    const char* text;
};

std::string name_of_hang(const ::testing::TestParamInfo<Hang>& hang) {
    return hang.param.name;
}

class LibraryHangs : public ::testing::TestWithParam<Hang> {};

TEST_P(LibraryHangs, AreRefused) {
    EXPECT_NE(mistake(GetParam().text, kSmall), "");
}

INSTANTIATE_TEST_SUITE_P(
    Limits,
    LibraryHangs,
    ::testing::Values(
        Hang{"EmptyRepeat", "local s = (\"\"):rep(math.maxinteger)"},
        Hang{"Backtracking", "(\"a\"):rep(1e5):find((\"a*\"):rep(50) .. \"b\")"},
        Hang{"PlainFind", "(\"a\"):rep(1e6):find((\"a\"):rep(5e5) .. \"b\", 1, true)"},
        Hang{"GsubBacktracking", "(\"a\"):rep(1e5):gsub(\".-.-.-b\", \"\")"},
        Hang{"MoveNothing", "table.move({}, 1, math.maxinteger - 1, 2)"},
        Hang{
            "LongInsert",
            "table.insert(setmetatable({}, {__len = function() return 1 << 60 end}), 1, 1)"},
        Hang{
            "LongRemove",
            "table.remove(setmetatable({}, {__len = function() return 1 << 60 end}), 1)"},
        Hang{
            "LongSort",
            "table.sort(setmetatable({}, {__len = function() return 1 << 30 end}), getmetatable)"},
        Hang{"LongUnpack", "table.unpack({}, 1, 1e8)"},
        Hang{"DeepRecursion", "local function f() return 1 + f() end f()"},
        Hang{"DeepCoroutines", "local function f() coroutine.wrap(f)() end f()"},
        Hang{"DeepGsub", "local function f() return (\"a\"):gsub(\"a\", f) end f()"},
        Hang{"ErrorInHandler", "xpcall(error, function(m) error(m) end) error(\"x\")"}),
    name_of_hang);

TEST(Limits, HoldForDeepNesting) {
    std::string text = "return ";
    for (int i = 0; i < 100'000; ++i)
        text += "{";

    EXPECT_THAT(mistake(text), HasSubstr("overflow"));
}

TEST(Limits, HoldForTablesThatBranch) {
    EXPECT_THAT(
        mistake("local t = {1}\nfor i = 1, 25 do t = {t, t} end\nreturn g.scene { t }"),
        HasSubstr("too many values"));
}

TEST(Limits, HoldForTextThatIsSharedOften) {
    EXPECT_THAT(
        mistake("local s, t = (\"x\"):rep(1e6), {}\nfor i = 1, 1000 do t[i] = s end\nreturn "
                "g.scene { t }"),
        HasSubstr("too much text"));
}

TEST(Determinism, PairsWalksSortedKeys) {
    EXPECT_THAT(
        printed("local t = { b = 1, a = 1, [10] = 1, [2.5] = 1, [true] = 1, c = 1, [-1] = 1 }\n"
                "for k in pairs(t) do print(k) end"),
        ElementsAre("-1", "2.5", "10", "a", "b", "c", "true"));
}

TEST(Determinism, PairsSkipsWhatWasTakenOutMeanwhile) {
    EXPECT_THAT(
        printed(
            "local t = { a = 1, b = 2, c = 3 }\nfor k, v in pairs(t) do print(k, v) t.b = nil end"),
        ElementsAre("a\t1", "c\t3"));
}

TEST(Determinism, PairsHonoursItsMetamethod) {
    EXPECT_THAT(
        printed("local t = setmetatable({}, {__pairs = function() return function(_, k) if not k "
                "then return 1, 2 end end end})\n"
                "for k, v in pairs(t) do print(k, v) end"),
        ElementsAre("1\t2"));
}

TEST(Determinism, RandomNumbersAreTheSameInEveryRun) {
    const std::string text = "print(math.random(1000000), math.random())";

    EXPECT_EQ(printed(text), printed(text));
}

TEST(Determinism, TablesHaveNoAddresses) {
    EXPECT_THAT(
        printed("print({}, print, tostring({}), string.format(\"%s %5s\", {}, 1))"),
        ElementsAre("table\tfunction\ttable\ttable     1"));
}

TEST(Determinism, AddressesCannotBeFormatted) {
    EXPECT_THAT(mistake("string.format(\"%-10p\", {})"), HasSubstr("addresses (%p) differ"));
}

TEST(Output, IsKeptLineByLine) {
    EXPECT_THAT(printed("print(1, \"two\", nil)\nprint()"), ElementsAre("1\ttwo\tnil", ""));
}

TEST(Output, IsCutBeforeItFillsTheMemory) {
    EXPECT_EQ(printed("for i = 1, 5000 do print(i) end").size(), 1000U);
}

} // namespace

} // namespace script
