#include <gtest/gtest.h>

#include <filesystem>

#include "tools/gnomon/row_pictures.hpp"

namespace gnomon {
namespace {

measure::Row row() {
    measure::Row row;
    row.scene = "yard";
    row.light = "lamp 1";
    row.technique = "map@1024:pcf";
    return row;
}

TEST(RowPictures, AreNamedAfterSceneLightAndTechnique) {
    EXPECT_EQ(picture_stem(row()), "yard_lamp_1_map_1024_pcf");
}

TEST(RowPictures, OfAMotionAreNamedAfterItToo) {
    measure::Row walking = row();
    walking.protocol = "walk";

    EXPECT_EQ(picture_stem(walking), "yard_lamp_1_map_1024_pcf_walk");
}

TEST(RowPictures, ShowErrorMaskAndColor) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / "gnomon_row_pictures";
    std::filesystem::create_directories(folder);
    measure::Mask dark(2, 1, 1.0F);
    dark.at(1, 0) = 0.0F;
    const auto comparison = measure::comparison(dark, measure::Mask(2, 1, 1.0F));
    engine::Image color(2, 1, 4);
    color.bytes = {1, 2, 3, 255, 4, 5, 6, 255};

    ASSERT_TRUE(write_row_pictures(folder, row(), comparison, color));

    const std::string stem = (folder / picture_stem(row())).string();
    const auto mask = engine::read_png(stem + "_mask.png");
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->channels, 1);
    EXPECT_EQ(mask->bytes, (std::vector<std::uint8_t>{255, 0}));
    const auto lit = engine::read_png(stem + "_color.png");
    ASSERT_TRUE(lit);
    EXPECT_EQ(lit->bytes, color.bytes);
    const auto error = engine::read_png(stem + "_error.png");
    ASSERT_TRUE(error);
    EXPECT_GT(*error->at(0, 0), 128) << "lit and right: pale";
    EXPECT_GT(error->at(1, 0)[0], error->at(1, 0)[2]) << "dark for lit: reddish or yellow";
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace gnomon
