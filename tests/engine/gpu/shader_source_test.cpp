#include "engine/gpu/shader_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

namespace gpu {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Reads from a map, as if from a folder.
ShaderReader reader(std::map<std::string, std::string> files) {
    return [files = std::move(files)](const std::string& name) -> engine::Result<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return engine::Error{"no shader file '" + name + "'"};
        return found->second;
    };
}

TEST(ExpandShader, PutsIncludesAndDefinesIn) {
    const ShaderReader read = reader(
        {{"m/main.frag",
          "// What it is.\n#version 450 core\n#include \"m/a.glsl\"\nvoid main() {}\n"},
         {"m/a.glsl", "float a;\n"}});
    const std::vector<std::string> defines = {"LAYERS=4", "SOFT"};

    const engine::Result<ExpandedShader> expanded = expand_shader("m/main.frag", defines, read);

    ASSERT_TRUE(expanded);
    EXPECT_EQ(
        expanded->text,
        "// What it is.\n#version 450 core\n#define LAYERS 4\n#define SOFT\nfloat a;\nvoid main() "
        "{}\n");
    EXPECT_THAT(expanded->files, ElementsAre("m/main.frag", "m/a.glsl"));
}

TEST(ExpandShader, IncludesEachFileOnce) {
    const ShaderReader read = reader(
        {{"m/main.frag", "#version 450\n#include \"m/a.glsl\"\n#include \"m/b.glsl\"\n"},
         {"m/a.glsl", "#include \"m/b.glsl\"\nfloat a;\n"},
         {"m/b.glsl", "#include \"m/a.glsl\"\nfloat b;\n"}});

    const engine::Result<ExpandedShader> expanded = expand_shader("m/main.frag", {}, read);

    ASSERT_TRUE(expanded);
    EXPECT_THAT(expanded->files, ElementsAre("m/main.frag", "m/a.glsl", "m/b.glsl"));
    EXPECT_EQ(expanded->text.find("float b;"), expanded->text.rfind("float b;"));
}

TEST(ExpandShader, KeepsLineNumbersOfHeadersSharedWithCpp) {
    const ShaderReader read = reader(
        {{"m/main.frag", "#version 450\n#include \"m/shared/s.h\"\n"},
         {"m/shared/s.h", "#pragma once\n#include <glm/glm.hpp>\nfloat s;\n"}});

    const engine::Result<ExpandedShader> expanded = expand_shader("m/main.frag", {}, read);

    ASSERT_TRUE(expanded);
    EXPECT_EQ(expanded->text, "#version 450\n\n\nfloat s;\n");
    EXPECT_EQ(expanded->lines.back().file, "m/shared/s.h");
    EXPECT_EQ(expanded->lines.back().line, 3);
}

TEST(ExpandShader, NamesTheLineThatIncludesAMissingFile) {
    const ShaderReader read = reader(
        {{"m/main.frag", "#version 450\n#include \"m/a.glsl\"\n"},
         {"m/a.glsl", "\n\n#include \"m/none.glsl\"\n"}});

    const engine::Result<ExpandedShader> expanded = expand_shader("m/main.frag", {}, read);

    ASSERT_FALSE(expanded);
    EXPECT_EQ(engine::to_string(expanded.error()), "m/a.glsl:3: no shader file 'm/none.glsl'");
}

TEST(ExpandShader, RefusesAMainFileWithoutVersion) {
    const engine::Result<ExpandedShader> expanded =
        expand_shader("m/main.frag", {}, reader({{"m/main.frag", "void main() {}\n"}}));

    ASSERT_FALSE(expanded);
    EXPECT_THAT(expanded.error().message, HasSubstr("#version"));
}

TEST(ExpandShader, RefusesAVersionInAnInclude) {
    const ShaderReader read = reader(
        {{"m/main.frag", "#version 450\n#include \"m/a.glsl\"\n"}, {"m/a.glsl", "#version 330\n"}});

    const engine::Result<ExpandedShader> expanded = expand_shader("m/main.frag", {}, read);

    ASSERT_FALSE(expanded);
    EXPECT_EQ(expanded.error().place.file, "m/a.glsl");
    EXPECT_EQ(expanded.error().place.line, 1);
}

constexpr std::array<ShaderFile, 2> kFiles = {
    {{"lit.frag", "#version 450\n"}, {"include/normal.glsl", "vec3 n;\n"}}};

TEST(ReadShader, FindsEmbeddedFilesByTheirVirtualName) {
    const std::vector<ShaderFolder> folders = {{"render", kFiles}};

    const engine::Result<std::string> text = read_shader(folders, "render/include/normal.glsl");

    ASSERT_TRUE(text);
    EXPECT_EQ(*text, "vec3 n;\n");
}

TEST(ReadShader, ProposesTheNearestName) {
    const std::vector<ShaderFolder> folders = {{"render", kFiles}};

    const engine::Result<std::string> text = read_shader(folders, "render/include/normel.glsl");

    ASSERT_FALSE(text);
    EXPECT_THAT(text.error().message, HasSubstr("did you mean 'render/include/normal.glsl'"));
}

/// A shader of three lines: of the main file, of an include, and of the main file again.
ExpandedShader three_lines() {
    return {
        "a\nb\nc\n",
        {"m/main.frag", "m/a.glsl"},
        {{"m/main.frag", 1}, {"m/a.glsl", 17}, {"m/main.frag", 3}}};
}

struct LogCase {
    const char* name;
    const char* log;
    const char* readable;
};

class ReadableLog : public testing::TestWithParam<LogCase> {};

TEST_P(ReadableLog, NamesTheFile) {
    EXPECT_EQ(readable_log(GetParam().log, three_lines()), GetParam().readable);
}

INSTANTIATE_TEST_SUITE_P(
    Drivers,
    ReadableLog,
    testing::Values(
        LogCase{
            "Nvidia",
            "0(2) : error C1503: undefined variable \"x\"\n",
            "m/a.glsl:17: error C1503: undefined variable \"x\"\n"},
        LogCase{"Mesa", "0:2(4): error: `x' undeclared\n", "m/a.glsl:17: error: `x' undeclared\n"},
        LogCase{
            "ErrorFirst",
            "ERROR: 0:3: 'x' : undeclared identifier\n",
            "m/main.frag:3: error: 'x' : undeclared identifier\n"},
        LogCase{"LineBeyondTheEnd", "0(4) : error\n", "0(4) : error\n"},
        LogCase{"NoPlace", "2 errors generated\n", "2 errors generated\n"},
        LogCase{"Empty", "", ""}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ErrorFromLog, StartsAtTheFirstErrorAndKeepsTheRest) {
    const engine::Error error = error_from_log(
        "0:1(1): warning: odd\n0:2(2): error: bad\n0:3(1): error: worse\n", three_lines());

    EXPECT_EQ(
        engine::to_string(error),
        "m/a.glsl:17: error: bad\nm/main.frag:1: warning: odd\nm/main.frag:3: error: worse");
}

} // namespace
} // namespace gpu
