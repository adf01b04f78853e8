#include "engine/core/check.hpp"
#include "engine/gpu/pass.hpp"
#include "engine/gpu/readback.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>

namespace gpu {
namespace {

using testing::Each;

constexpr std::array<ShaderFile, 3> kFiles = {
    {{"triangle.vert",
      "#version 450\n"
      "layout(location = 0) in vec4 position_cs;\n"
      "void main() { gl_Position = position_cs; }\n"},
     {"paint.frag",
      "#version 450\n"
      "uniform vec4 paint;\n"
      "layout(location = 0) out vec4 color;\n"
      "void main() { color = paint; }\n"},
     {"compare.frag",
      "#version 450\n"
      "layout(binding = 0) uniform sampler2DShadow map;\n"
      "uniform float reference;\n"
      "layout(location = 0) out vec4 color;\n"
      "void main() { color = vec4(texture(map, vec3(0.5, 0.5, reference))); }\n"}}};

/// A target of 4 x 4 pixels with colour, depth and stencil, and programs to draw into it.
class PassGl : public test_support::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        library_ = std::make_unique<ShaderLibrary>(std::vector<ShaderFolder>{{"test", kFiles}});
        color_ = Texture("color", {.width = 4, .height = 4});
        depth_ = Texture("depth", {.format = Format::depth32f_stencil8, .width = 4, .height = 4});
        auto made = Framebuffer::make(
            "target", {.colors = {{.texture = &color_}}, .depth = Attachment{&depth_}});
        ASSERT_TRUE(made);
        target_ = *std::move(made);
        frame_ = std::make_unique<Frame>(TimerBackend::finish);
    }

    const Program& program(const std::string& vertex, const std::string& fragment) {
        const engine::Result<const Program*> made = library_->graphics(vertex, fragment);
        CHECK(made);
        return **made;
    }
    const Program& paint(const glm::vec4& color) {
        const Program& made = program("test/triangle.vert", "test/paint.frag");
        made.set("paint", color);
        return made;
    }
    const Program& screen_paint(const glm::vec4& color) {
        const Program& made = program("gpu/fullscreen.vert", "test/paint.frag");
        made.set("paint", color);
        return made;
    }
    /// A triangle over the whole target whose corners are at (x, y, z, w) * scale.
    VertexArray triangle(float z, float w) {
        const std::vector<glm::vec4> corners = {
            {-w, -w, z, w}, {3.0F * w, -w, z, w}, {-w, 3.0F * w, z, w}};
        vertices_ = Buffer::fixed("corners", bytes_of(corners));
        return VertexArray(
            "triangle",
            std::vector<VertexStream>{
                {.buffer = &vertices_, .stride_bytes = 16, .attributes = {{.components = 4}}}});
    }
    glm::ivec4 color_at(int x, int y) {
        const engine::Image image = read_image(color_);
        const std::uint8_t* pixel = image.at(x, y);
        return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }

    std::unique_ptr<ShaderLibrary> library_;
    Texture color_;
    Texture depth_;
    Framebuffer target_;
    Buffer vertices_;
    std::unique_ptr<Frame> frame_;
};

constexpr glm::vec4 kRed = {1.0F, 0.0F, 0.0F, 1.0F};
constexpr glm::ivec4 kRedPixel = {255, 0, 0, 255};

TEST_F(PassGl, ClearsWhatItNamesEvenWhenWritesWereOff) {
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "first", target_);
        frame_->state(
            {.depth_write = false,
             .color_write = kWriteNoColor,
             .stencil = Stencil::both({.write_mask = 0}),
             .scissor = Rect{0, 0, 1, 1}});
        frame_->draw_fullscreen(screen_paint(kRed));
    }
    {
        const ScopedPass pass(
            *frame_, "second", target_, {.color = kRed, .depth = 0.25F, .stencil = 9});
    }
    frame_->end();

    EXPECT_EQ(color_at(3, 3), kRedPixel);
    EXPECT_THAT(read_depth(depth_).values, Each(0.25F));
    EXPECT_THAT(read_stencil(depth_).values, Each(9));
}

TEST_F(PassGl, ClearsAnAreaAndLeavesTheRest) {
    frame_->begin();
    { const ScopedPass pass(*frame_, "all", target_, {.color = glm::vec4(0.0F)}); }
    {
        const ScopedPass pass(
            *frame_, "corner", target_, {.color = kRed, .area = Rect{0, 0, 2, 1}});
    }
    frame_->end();

    EXPECT_EQ(color_at(1, 3), kRedPixel);
    EXPECT_EQ(color_at(1, 2), glm::ivec4(0));
    EXPECT_EQ(color_at(2, 3), glm::ivec4(0));
}

TEST_F(PassGl, ClearsIntegersToIntegers) {
    const Texture ids("ids", {.format = Format::r32ui, .width = 2, .height = 2});
    const auto target = Framebuffer::make("ids", {.colors = {{.texture = &ids}}});
    ASSERT_TRUE(target);

    frame_->begin();
    { const ScopedPass pass(*frame_, "ids", *target, {.color = glm::vec4(3.0F)}); }
    frame_->end();

    EXPECT_THAT(read_uints(ids).values, Each(3U));
}

TEST_F(PassGl, APointAtInfinityHasDepthZeroAndTheNearPlaneOne) {
    constexpr float kNear = 0.1F;
    const auto depth_of = [this](float z, float w) {
        frame_->begin();
        {
            const ScopedPass pass(*frame_, "depth", target_, {.depth = 0.5F});
            frame_->state({.depth_test = Compare::always, .depth_clamp = false});
            frame_->draw(paint(kRed), triangle(z, w), {.count = 3});
        }
        frame_->end();
        return read_depth(depth_).at(0, 0);
    };

    // With a reversed infinite projection clip z is the near distance everywhere, and clip w the
    // distance.
    EXPECT_EQ(depth_of(kNear, kNear), 1.0F);
    EXPECT_EQ(depth_of(0.0F, 1.0F), 0.0F);
    EXPECT_FLOAT_EQ(depth_of(kNear, 1.0F), 0.1F);
}

TEST_F(PassGl, NearerIsGreaterAndWins) {
    const glm::vec4 green = {0.0F, 1.0F, 0.0F, 1.0F};
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "depth", target_, {.color = glm::vec4(0.0F), .depth = 0.0F});
        frame_->draw(paint(kRed), triangle(0.5F, 1.0F), {.count = 3});
        frame_->draw(paint(green), triangle(0.25F, 1.0F), {.count = 3});
    }
    frame_->end();

    EXPECT_EQ(color_at(0, 0), kRedPixel);
}

TEST_F(PassGl, BlendsByMinimum) {
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "mask", target_, {.color = glm::vec4(0.5F)});
        RenderState state = kScreenState;
        state.blend = Blend::min;
        frame_->state(state);
        frame_->draw_fullscreen(screen_paint({1.0F, 0.0F, 1.0F, 0.0F}));
    }
    frame_->end();

    EXPECT_EQ(color_at(2, 2), glm::ivec4(128, 0, 128, 0));
}

TEST_F(PassGl, ASmallViewportDoesNotOutliveItsState) {
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "viewport", target_, {.color = glm::vec4(0.0F)});
        RenderState state = kScreenState;
        state.viewport = Rect{0, 0, 2, 2};
        frame_->state(state);
        frame_->draw_fullscreen(screen_paint(kRed));
        frame_->state(kScreenState);
        frame_->draw_fullscreen(screen_paint({0.0F, 0.0F, 1.0F, 1.0F}));
    }
    frame_->end();

    EXPECT_EQ(color_at(3, 0), glm::ivec4(0, 0, 255, 255));
}

TEST_F(PassGl, ComparesReversedDepthsInTheSampler) {
    Texture map(
        "map",
        {.format = Format::depth32f,
         .sampling = {.min = Filter::linear, .mag = Filter::linear, .compare = true}});
    map.upload(bytes_of(std::vector<float>{0.5F}));
    const Program& compare = program("gpu/fullscreen.vert", "test/compare.frag");
    const auto lit_at = [&](float reference) {
        frame_->begin();
        {
            const ScopedPass pass(*frame_, "compare", target_);
            frame_->state(kScreenState);
            map.bind(0);
            compare.set("reference", reference);
            frame_->draw_fullscreen(compare);
        }
        frame_->end();
        return color_at(0, 0).x;
    };

    EXPECT_EQ(lit_at(0.75F), 255);
    EXPECT_EQ(lit_at(0.5F), 255);
    EXPECT_EQ(lit_at(0.25F), 0);
}

TEST_F(PassGl, ASamplerReplacesTheTexturesOwnSampling) {
    Texture map("map", {.format = Format::depth32f}); // no comparison of its own
    map.upload(bytes_of(std::vector<float>{0.5F}));
    const Sampler comparing("comparing", {.compare = true});
    const Program& compare = program("gpu/fullscreen.vert", "test/compare.frag");
    compare.set("reference", 0.75F);

    frame_->begin();
    {
        const ScopedPass pass(*frame_, "compare", target_, {.color = glm::vec4(0.0F)});
        frame_->state(kScreenState);
        map.bind(0, comparing);
        frame_->draw_fullscreen(compare);
    }
    frame_->end();

    EXPECT_EQ(color_at(0, 0).x, 255);
}

TEST_F(PassGl, CountsDrawsTrianglesAndChangesPerFrame) {
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "count", target_);
        frame_->draw(paint(kRed), triangle(0.5F, 1.0F), {.count = 3, .instances = 4});
        frame_->draw_fullscreen(screen_paint(kRed));
    }
    frame_->end();

    EXPECT_EQ(frame_->counters().draws, 2U);
    EXPECT_EQ(frame_->counters().triangles, 5U);
    EXPECT_GT(frame_->counters().state_changes, 0U);
}

TEST_F(PassGl, SetsTheSameStateOnce) {
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "once", target_);
        frame_->state(kScreenState);
        const std::uint64_t before = frame_->state_cache().change_count();
        frame_->state(kScreenState);
        EXPECT_EQ(frame_->state_cache().change_count(), before);
    }
    frame_->end();
}

TEST_F(PassGl, RecoversAfterForeignCodeChangedTheState) {
    frame_->begin();
    {
        const ScopedPass pass(*frame_, "foreign", target_, {.color = glm::vec4(0.0F)});
        frame_->state(kScreenState);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        frame_->state_cache().forget();
        frame_->state(kScreenState);
        frame_->draw_fullscreen(screen_paint(kRed));
    }
    frame_->end();

    EXPECT_EQ(color_at(0, 0), kRedPixel);
}

using PassDeathTest = PassGl;

TEST_F(PassDeathTest, PassesDoNotNest) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");

    EXPECT_DEATH(
        {
            frame_->begin();
            const ScopedPass outer(*frame_, "outer", target_);
            const ScopedPass inner(*frame_, "inner", target_);
        },
        "in_pass_");
}

} // namespace
} // namespace gpu
