#include "engine/gpu/buffer.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/texture.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <cstring>

namespace gpu {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

class BufferGl : public test_support::GlTest {};
class TextureGl : public test_support::GlTest {};
class FramebufferGl : public test_support::GlTest {};

std::vector<std::uint32_t> contents(const Buffer& buffer, std::size_t count) {
    std::vector<std::uint32_t> values(count);
    buffer.read(std::as_writable_bytes(std::span(values)));
    return values;
}

TEST_F(BufferGl, KeepsWhatItWasMadeWith) {
    const std::vector<std::uint32_t> values = {1, 2, 3, 4, 5};

    const Buffer buffer = Buffer::fixed("five", bytes_of(values));

    EXPECT_EQ(contents(buffer, 5), values);
    EXPECT_EQ(buffer.size_bytes(), 20U);
}

TEST_F(BufferGl, HoldsLessThanTheSmallestStore) {
    const std::vector<std::uint32_t> values = {7};

    const Buffer buffer = Buffer::fixed("one", bytes_of(values));

    EXPECT_EQ(contents(buffer, 1), values);
}

TEST_F(BufferGl, GrowsWhenMoreIsAssignedAndKeepsItsName) {
    Buffer buffer = Buffer::dynamic("growing");
    const GLuint name = buffer.name();
    const std::vector<std::uint32_t> values(100, 9);

    buffer.assign(bytes_of(values));

    EXPECT_EQ(contents(buffer, 100), values);
    EXPECT_EQ(buffer.capacity_bytes(), 512U);
    EXPECT_EQ(buffer.name(), name);
}

TEST_F(BufferGl, WritesAPartAndClearsTheWhole) {
    Buffer buffer = Buffer::dynamic("part", 16);
    buffer.clear();

    buffer.write(4, bytes_of(std::vector<std::uint32_t>{5, 6}));

    EXPECT_THAT(contents(buffer, 4), ElementsAre(0U, 5U, 6U, 0U));
}

TEST_F(BufferGl, CountsItsBytesWhileItLives) {
    const std::uint64_t before = device_bytes();
    {
        Buffer buffer = Buffer::dynamic("counted", 1000);
        const Buffer moved = std::move(buffer);
        EXPECT_EQ(device_bytes(), before + 1000);
    }
    EXPECT_EQ(device_bytes(), before);
}

TEST_F(TextureGl, ReadsBackItsTopRowFirst) {
    const std::vector<std::uint8_t> bottom_first = {1, 2, 3, 4, 5, 6};
    Texture texture("two rows", {.format = Format::r8, .width = 3, .height = 2});

    texture.upload(bytes_of(bottom_first));

    EXPECT_THAT(read_image(texture).bytes, ElementsAre(4, 5, 6, 1, 2, 3));
}

TEST_F(TextureGl, KeepsLayersApart) {
    Texture texture(
        "layers",
        {.kind = TextureKind::array,
         .format = Format::r32ui,
         .width = 1,
         .height = 1,
         .layers = 3});
    const std::vector<std::uint32_t> value = {77};

    texture.clear();
    texture.upload(bytes_of(value), 0, 1);

    EXPECT_EQ(read_uints(texture, 0, 0).at(0, 0), 0U);
    EXPECT_EQ(read_uints(texture, 0, 1).at(0, 0), 77U);
    EXPECT_EQ(read_uints(texture, 0, 2).at(0, 0), 0U);
}

TEST_F(TextureGl, KeepsCubeFacesApart) {
    Texture cube(
        "cube", {.kind = TextureKind::cube, .format = Format::r32f, .width = 2, .height = 2});
    const std::vector<float> face = {1.0F, 2.0F, 3.0F, 4.0F};

    cube.clear();
    cube.upload(bytes_of(face), 0, 5);

    EXPECT_EQ(cube.layers(), 6);
    EXPECT_THAT(read_floats(cube, 0, 4).values, Each(0.0F));
    EXPECT_THAT(read_floats(cube, 0, 5).values, ElementsAre(3.0F, 4.0F, 1.0F, 2.0F));
}

TEST_F(TextureGl, ReadsFacesOfCubeArrays) {
    Texture cubes(
        "cubes",
        {.kind = TextureKind::cube_array,
         .format = Format::depth32f,
         .width = 1,
         .height = 1,
         .layers = 2});
    const std::vector<float> depth = {0.25F};

    cubes.upload(bytes_of(depth), 0, 6 + 2);

    EXPECT_EQ(cubes.layers(), 12);
    EXPECT_FLOAT_EQ(read_depth(cubes, 0, 8).at(0, 0), 0.25F);
}

TEST_F(TextureGl, WholeChainOfLevelsEndsAtOnePixel) {
    Texture texture("chain", {.format = Format::r8, .width = 8, .height = 3, .levels = 0});
    texture.upload(bytes_of(std::vector<std::uint8_t>(24, 100)));

    texture.make_mip_levels();

    EXPECT_EQ(texture.levels(), 4);
    EXPECT_EQ(texture.width(3), 1);
    EXPECT_EQ(read_image(texture, 3).bytes, std::vector<std::uint8_t>({100}));
    EXPECT_EQ(texture.size_bytes(), 24U + 4U + 2U + 1U);
}

TEST_F(TextureGl, UploadsARegion) {
    Texture texture("region", {.format = Format::rg32ui, .width = 2, .height = 2});
    texture.clear();
    const std::vector<glm::uvec2> pair = {{3, 4}};

    texture.upload(bytes_of(pair), 0, 0, {1, 0, 1, 1});

    const Pixels<glm::uvec2> pixels = read_uint_pairs(texture);
    EXPECT_EQ(pixels.at(1, 1), glm::uvec2(3, 4));
    EXPECT_EQ(pixels.at(1, 0), glm::uvec2(0));
}

TEST_F(TextureGl, ReadsSrgbBytesAsTheyAreStored) {
    Texture texture("srgb", {.format = Format::srgb8_alpha8});
    const std::vector<std::uint8_t> pixel = {10, 128, 250, 77};

    texture.upload(bytes_of(pixel));

    EXPECT_EQ(read_image(texture).bytes, pixel);
}

class EveryFormatGl : public test_support::GlTest, public testing::WithParamInterface<int> {};

TEST_P(EveryFormatGl, TakesUploadsOfTheSizeThatItsTraitsSay) {
    const auto format = static_cast<Format>(GetParam());
    Texture texture("format", {.format = format, .width = 3, .height = 2});
    const std::vector<std::byte> pixels(
        static_cast<std::size_t>(6 * traits(format).pixel_bytes), std::byte{0});

    texture.upload(pixels);
    texture.clear(0, std::span(pixels).first(pixels.size() / 6));

    EXPECT_EQ(texture.size_bytes(), pixels.size());
}

INSTANTIATE_TEST_SUITE_P(
    Formats, EveryFormatGl, testing::Range(0, static_cast<int>(Format::depth32f_stencil8) + 1));

TEST_F(FramebufferGl, HasTheSizeOfItsSmallestAttachment) {
    const Texture color("color", {.width = 8, .height = 4});
    const Texture depth("depth", {.format = Format::depth32f, .width = 6, .height = 9});

    const engine::Result<Framebuffer> target =
        Framebuffer::make("both", {.colors = {{.texture = &color}}, .depth = Attachment{&depth}});

    ASSERT_TRUE(target);
    EXPECT_EQ(target->whole(), (Rect{0, 0, 6, 4}));
}

TEST_F(FramebufferGl, SaysWhyItCannotBeDrawnInto) {
    const engine::Result<Framebuffer> target = Framebuffer::make("nothing at all", {});

    ASSERT_FALSE(target);
    EXPECT_THAT(target.error().message, HasSubstr("'nothing at all'"));
    EXPECT_THAT(target.error().message, HasSubstr("it has no attachment"));
}

TEST_F(FramebufferGl, DrawsIntoOneLayerOrOneFace) {
    const Texture cube(
        "cube", {.kind = TextureKind::cube, .format = Format::depth32f, .width = 4, .height = 4});

    const engine::Result<Framebuffer> face =
        Framebuffer::make("face", {.depth = Attachment{.texture = &cube, .layer = 3}});
    const engine::Result<Framebuffer> all =
        Framebuffer::make("all", {.depth = Attachment{.texture = &cube, .layer = kAllLayers}});

    EXPECT_TRUE(face);
    EXPECT_TRUE(all);
}

} // namespace
} // namespace gpu
