// Pictures made small.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "tools/page/picture.hpp"

namespace {

using testing::ElementsAre;
using testing::StartsWith;

engine::Image row_of(std::vector<std::uint8_t> grey) {
    engine::Image image(static_cast<int>(grey.size()), 1, 1);
    image.bytes = std::move(grey);
    return image;
}

TEST(PagePicture, IsTheMeanOfWhatEachPixelCovers) {
    // Two thirds of a source and a third of the next one make a pixel.
    EXPECT_THAT(page::at_most_wide(row_of({0, 90, 240}), 2).bytes, ElementsAre(30, 190));
    EXPECT_THAT(page::at_most_wide(row_of({10, 30, 50, 70}), 2).bytes, ElementsAre(20, 60));
}

TEST(PagePicture, KeepsItsShape) {
    const engine::Image small = page::at_most_wide(engine::Image(1280, 720, 3), 640);

    EXPECT_EQ(small.width, 640);
    EXPECT_EQ(small.height, 360);
    EXPECT_EQ(small.channels, 3);
}

TEST(PagePicture, MixesNoChannels) {
    engine::Image image(2, 2, 3);
    for (int i = 0; i < 4; ++i)
        image.at(i % 2, i / 2)[i % 3] = 200; // red twice, green and blue once

    EXPECT_THAT(page::at_most_wide(image, 1).bytes, ElementsAre(100, 50, 50));
}

TEST(PagePicture, ThatIsSmallStaysAsItIs) {
    const engine::Image image = row_of({1, 2, 3});

    EXPECT_EQ(page::at_most_wide(image, 3).bytes, image.bytes);
}

TEST(PagePicture, KeepsItsMeanAtAnyWidth) {
    std::vector<std::uint8_t> ramp(251);
    std::iota(ramp.begin(), ramp.end(), 0);
    const engine::Image image = row_of(ramp);

    for (const int width : {1, 7, 100, 250}) {
        SCOPED_TRACE(width);
        const engine::Image small = page::at_most_wide(image, width);
        const double sum = std::accumulate(small.bytes.begin(), small.bytes.end(), 0.0);
        EXPECT_NEAR(sum / width, 125.0, 0.51); // every pixel is rounded
    }
}

// The first bytes of the two formats in base64.
TEST(PagePicture, IsAPngOrAJpegFile) {
    EXPECT_THAT(page::png_url(row_of({0, 255})), StartsWith("data:image/png;base64,iVBORw0KGgo"));
    EXPECT_THAT(page::jpeg_url(row_of({0, 255})), StartsWith("data:image/jpeg;base64,/9j/"));
}

} // namespace
