#include "engine/gpu/pass.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/shader_library.hpp"
#include "tests/support/gl_fixture.hpp"

#include <filesystem>
#include <fstream>

#include "gpu/shared/glsl.h"

namespace gpu {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace fs = std::filesystem;

/// A library over a folder on disk that the test writes.
class ShaderLibraryGl : public test_support::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        std::string pattern = (fs::temp_directory_path() / "gnomon-shaders-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        library_ = std::make_unique<ShaderLibrary>(
            std::vector<ShaderFolder>{{.virtual_root = "test", .files = {}, .disk_path = folder_}});
        color_ = Texture("color", {});
        auto made = Framebuffer::make("target", {.colors = {{.texture = &color_}}});
        ASSERT_TRUE(made);
        target_ = *std::move(made);
        frame_ = std::make_unique<Frame>(TimerBackend::finish);
    }
    void TearDown() override {
        if (!folder_.empty()) fs::remove_all(folder_);
        GlTest::TearDown();
    }

    /// Each write gets a later time than the one before, however fast the test runs.
    void write(const std::string& path, const std::string& text) {
        const fs::path file = fs::path(folder_) / path;
        fs::create_directories(file.parent_path());
        std::ofstream(file) << text;
        ++writes_;
        fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(writes_));
    }
    engine::Result<const Program*> paint(const Defines& defines = {}) {
        return library_->graphics("gpu/fullscreen.vert", "test/paint.frag", defines);
    }
    /// The red that the program paints.
    int painted(const Program& program) {
        frame_->begin();
        {
            const ScopedPass pass(*frame_, "paint", target_);
            frame_->state(kScreenState);
            frame_->draw_fullscreen(program);
        }
        frame_->end();
        return *read_image(color_).at(0, 0);
    }

    std::string folder_;
    int writes_ = 0;
    std::unique_ptr<ShaderLibrary> library_;
    Texture color_;
    Framebuffer target_;
    std::unique_ptr<Frame> frame_;
};

constexpr const char* kPaint = "#version 450\n"
                               "#include \"test/include/red.glsl\"\n"
                               "uniform float scale;\n"
                               "uniform float idle;\n"
                               "layout(location = 0) out vec4 color;\n"
                               "void main() { color = vec4(red() * scale); }\n";

TEST_F(ShaderLibraryGl, CompilesIncludes) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return 1.0; }\n");

    const engine::Result<const Program*> program = paint();

    ASSERT_TRUE(program) << engine::to_string(program.error());
    (*program)->set("scale", 0.2F);
    EXPECT_EQ(painted(**program), 51);
}

TEST_F(ShaderLibraryGl, ReportsErrorsAtTheLineOfTheInclude) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "\n\nfloat red() { return none; }\n");

    const engine::Result<const Program*> program = paint();

    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().place.file, "test/include/red.glsl");
    EXPECT_EQ(program.error().place.line, 3);
    EXPECT_THAT(program.error().message, HasSubstr("none"));
}

TEST_F(ShaderLibraryGl, ReportsErrorsAfterAnIncludeAtTheirOwnLine) {
    write(
        "paint.frag",
        "#version 450\n#include \"test/include/red.glsl\"\n\nvoid main() { oops; }\n");
    write("include/red.glsl", "float red() { return 1.0; }\n");

    const engine::Result<const Program*> program = paint({"SOFT"});

    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().place.file, "test/paint.frag");
    EXPECT_EQ(program.error().place.line, 4);
}

TEST_F(ShaderLibraryGl, ReportsLinkErrors) {
    write(
        "paint.frag",
        "#version 450\nin vec4 nobody_writes_this;\nout vec4 c;\nvoid main() { c = "
        "nobody_writes_this; }\n");

    const engine::Result<const Program*> program = paint();

    ASSERT_FALSE(program);
    EXPECT_THAT(engine::to_string(program.error()), HasSubstr("test/paint.frag: does not link"));
}

TEST_F(ShaderLibraryGl, CompilesEachVariantOnce) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return LEVEL; }\n");

    const engine::Result<const Program*> half = paint({"LEVEL=0.2"});
    const engine::Result<const Program*> full = paint({"LEVEL=1.0"});
    const engine::Result<const Program*> again = paint({"LEVEL=0.2"});

    ASSERT_TRUE(half);
    ASSERT_TRUE(full);
    EXPECT_EQ(*half, *again);
    EXPECT_EQ(library_->compile_count(), 2);
    (*half)->set("scale", 1.0F);
    (*full)->set("scale", 1.0F);
    EXPECT_EQ(painted(**half), 51);
    EXPECT_EQ(painted(**full), 255);
}

/// A header as modules share it, compiled by both languages.
TEST_F(ShaderLibraryGl, CompilesHeadersThatCppCompilesToo) {
    static_assert(sizeof(glsl::mat4) == 64 && sizeof(glsl::uint) == 4);
    write(
        "paint.frag",
        "#version 450\n"
        "#include \"gpu/shared/glsl.h\"\n"
        "layout(location = 0) out vec4 color;\n"
        "void main() { color = vec4(1.0); }\n");

    const engine::Result<const Program*> program = paint();

    ASSERT_TRUE(program) << engine::to_string(program.error());
}

TEST_F(ShaderLibraryGl, ReloadsWhenAnIncludeChanges) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return 0.2; }\n");
    const engine::Result<const Program*> program = paint();
    ASSERT_TRUE(program);

    write("include/red.glsl", "float red() { return 1.0; }\n");
    const std::vector<engine::Error> errors = library_->poll_now();

    EXPECT_THAT(errors, IsEmpty());
    (*program)->set("scale", 1.0F);
    EXPECT_EQ(painted(**program), 255);
}

TEST_F(ShaderLibraryGl, KeepsTheOldProgramWhenTheNewOneFails) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return 0.2; }\n");
    const engine::Result<const Program*> program = paint();
    ASSERT_TRUE(program);
    (*program)->set("scale", 1.0F);

    write("include/red.glsl", "float red() { return }\n");
    const std::vector<engine::Error> errors = library_->poll_now();

    ASSERT_THAT(errors, SizeIs(1));
    EXPECT_EQ(errors.front().place.file, "test/include/red.glsl");
    EXPECT_EQ(painted(**program), 51);
    EXPECT_THAT(library_->poll_now(), IsEmpty()) << "the same error is reported once";
}

TEST_F(ShaderLibraryGl, RecoversWhenAMissingFileAppears) {
    write("paint.frag", kPaint);
    ASSERT_FALSE(paint());

    write("include/red.glsl", "float red() { return 1.0; }\n");
    const std::vector<engine::Error> errors = library_->poll_now();

    EXPECT_THAT(errors, IsEmpty());
    EXPECT_TRUE(paint());
}

TEST_F(ShaderLibraryGl, LooksAtTheDiskAtMostTwiceASecond) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return 0.2; }\n");
    ASSERT_TRUE(paint());
    ASSERT_THAT(library_->poll(), IsEmpty());

    write("include/red.glsl", "float red() { return }\n");

    EXPECT_THAT(library_->poll(), IsEmpty());
    EXPECT_THAT(library_->poll_now(), SizeIs(1));
}

TEST_F(ShaderLibraryGl, IgnoresAUniformThatTheCompilerRemoved) {
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return 1.0; }\n");
    const engine::Result<const Program*> program = paint();
    ASSERT_TRUE(program);

    (*program)->set("idle", 1.0F);
}

TEST_F(ShaderLibraryGl, DispatchesComputeShaders) {
    write(
        "double.comp",
        "#version 450\n"
        "layout(local_size_x = 4) in;\n"
        "layout(std430, binding = 2) buffer Values { uint values[]; };\n"
        "void main() { values[gl_GlobalInvocationID.x] *= 2u; }\n");
    const engine::Result<const Program*> program = library_->compute("test/double.comp");
    ASSERT_TRUE(program) << engine::to_string(program.error());
    std::vector<std::uint32_t> values = {1, 2, 3, 4};
    const Buffer buffer = Buffer::fixed("values", bytes_of(values));

    frame_->begin();
    {
        const ScopedPass pass(*frame_, "double");
        buffer.bind_storage(2);
        frame_->dispatch(**program, 1);
    }
    frame_->end();

    buffer.read(std::as_writable_bytes(std::span(values)));
    EXPECT_THAT(values, testing::ElementsAre(2U, 4U, 6U, 8U));
}

using ShaderLibraryDeathTest = ShaderLibraryGl;

TEST_F(ShaderLibraryDeathTest, AUniformThatNoSourceNamesIsAProgrammersSlip) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    write("paint.frag", kPaint);
    write("include/red.glsl", "float red() { return 1.0; }\n");
    const engine::Result<const Program*> program = paint();
    ASSERT_TRUE(program);

    EXPECT_DEATH((*program)->set("scael", 1.0F), "no 'scael' in this program's shaders");
}

} // namespace
} // namespace gpu
