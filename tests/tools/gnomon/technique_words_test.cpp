// A technique and its settings in one word, as people type them.

#include "systems/shadows/technique_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/gnomon/view_options.hpp"

namespace gnomon {
namespace {

using testing::HasSubstr;

ShadowOptions read(const std::string& word) {
    const auto options = options_from_word(word, shadows::all_techniques());
    EXPECT_TRUE(options) << word << ": " << engine::to_string(options.error());
    return *options;
}

std::string complaint(const std::string& word) {
    const auto options = options_from_word(word, shadows::all_techniques());
    EXPECT_FALSE(options) << word;
    return options ? "" : options.error().message;
}

TEST(TechniqueWords, SayOneSettingEach) {
    EXPECT_EQ(read("volume").technique, "volume");
    EXPECT_EQ(read("map@1024").map_size, 1024);
    EXPECT_EQ(read("map@1024x2").cascades, 2);
    EXPECT_EQ(read("map@1024:pcf").filter, "pcf");
    EXPECT_EQ(read("volume@1").proxy, 1);
    EXPECT_EQ(read("planar@16").samples, 16);
    EXPECT_EQ(read("planar:boxes").way, "boxes");
    EXPECT_EQ(read("auto@0.5").error_px, 0.5F);
}

TEST(TechniqueWords, EndInThePeriodOfARefresh) {
    const ShadowOptions options = read("map@512x3:pcf%4");
    EXPECT_EQ(options.map_size, 512);
    EXPECT_EQ(options.cascades, 3);
    EXPECT_EQ(options.filter, "pcf");
    EXPECT_EQ(options.period, 4);
    EXPECT_EQ(options.wish(scene::LightKind::directional).refresh, 4);
    EXPECT_EQ(read("shadow_texture%8").period, 8);
    EXPECT_FALSE(read("map").period);
}

TEST(TechniqueWords, SayWhatIsWrong) {
    EXPECT_THAT(complaint("volum"), HasSubstr("did you mean 'volume'"));
    EXPECT_THAT(complaint("map@8"), HasSubstr("'8' after '@' is no size or error"));
    EXPECT_THAT(complaint("map@1024x9"), HasSubstr("1 to 4 cascades"));
    EXPECT_THAT(complaint("volume@9"), HasSubstr("no level of simplified casters"));
    EXPECT_THAT(complaint("planar:bokses"), HasSubstr("'bokses' is no way of planar"));
    EXPECT_THAT(complaint("planar@0"), HasSubstr("no number of light samples"));
    EXPECT_THAT(complaint("map@1024%0"), HasSubstr("'0' after '%' is no number of frames"));
    EXPECT_THAT(complaint("map@1024%"), HasSubstr("'' after '%' is no number of frames"));
}

} // namespace
} // namespace gnomon
