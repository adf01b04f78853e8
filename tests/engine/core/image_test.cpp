#include "engine/core/image.hpp"
#include "engine/core/random.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::TestWithParam<int> {
protected:
    fs::path file_ =
        fs::path(testing::TempDir()) / ("image_test_" + std::to_string(GetParam()) + ".png");

    void TearDown() override { fs::remove(file_); }
};

TEST_P(ImageFile, ComesBackAsItWasWritten) {
    engine::Image image(7, 5, GetParam());
    engine::Random random(3);
    for (std::uint8_t& byte : image.bytes)
        byte = static_cast<std::uint8_t>(random.below(256));

    ASSERT_TRUE(engine::write_png(file_, image));
    const engine::Result<engine::Image> read = engine::read_png(file_);

    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->width, 7);
    EXPECT_EQ(read->height, 5);
    EXPECT_EQ(read->channels, GetParam());
    EXPECT_EQ(read->bytes, image.bytes);
}

INSTANTIATE_TEST_SUITE_P(
    Channels, ImageFile, testing::Values(1, 3, 4), testing::PrintToStringParamName());

TEST(Image, StartsBlackAndIsAddressedFromTheTopLeft) {
    engine::Image image(3, 2, 3);

    image.at(2, 1)[0] = 9;

    EXPECT_EQ(image.pixel_count(), 6U);
    EXPECT_EQ(image.bytes.size(), 18U);
    EXPECT_EQ(image.bytes[15], 9);
    EXPECT_EQ(image.at(0, 0)[0], 0);
}

TEST(Image, IsConvertedToTheChannelsAskedFor) {
    const fs::path file = fs::path(testing::TempDir()) / "image_test_convert.png";
    engine::Image grey(1, 1, 1);
    grey.bytes[0] = 77;
    ASSERT_TRUE(engine::write_png(file, grey));

    const engine::Result<engine::Image> read = engine::read_png(file, 4);
    fs::remove(file);

    ASSERT_TRUE(read);
    EXPECT_EQ(read->bytes, (std::vector<std::uint8_t>{77, 77, 77, 255}));
}

TEST(Image, ComesBackFromAJpegFileNearlyAsItWas) {
    const fs::path file = fs::path(testing::TempDir()) / "image_test.jpg";
    engine::Image ramp(32, 8, 3);
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                ramp.at(x, y)[channel] = static_cast<std::uint8_t>(8 * x / (channel + 1));
    const std::vector<std::uint8_t> bytes = engine::encode_jpeg(ramp, 95);
    std::ofstream(file, std::ios::binary)
        .write(
            reinterpret_cast<const char*>(bytes.data()), // NOLINT(*-reinterpret-cast): a stream
            static_cast<std::streamsize>(bytes.size()));

    const engine::Result<engine::Image> read = engine::read_png(file);
    fs::remove(file);

    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(read->bytes.size(), ramp.bytes.size());
    for (std::size_t i = 0; i < ramp.bytes.size(); ++i)
        EXPECT_NEAR(read->bytes[i], ramp.bytes[i], 12) << i;
}

TEST(Image, FailuresNameTheFile) {
    const fs::path text = fs::path(testing::TempDir()) / "image_test.txt";
    std::ofstream(text) << "no picture";

    const auto missing = engine::read_png("/nowhere/a.png");
    const auto no_picture = engine::read_png(text);
    const auto unwritable = engine::write_png("/nowhere/a.png", engine::Image(1, 1, 1));
    fs::remove(text);

    ASSERT_FALSE(missing);
    ASSERT_FALSE(no_picture);
    ASSERT_FALSE(unwritable);
    EXPECT_EQ(missing.error().place.file, "/nowhere/a.png");
    EXPECT_EQ(no_picture.error().place.file, text.string());
    EXPECT_EQ(unwritable.error().place.file, "/nowhere/a.png");
}

} // namespace
