// What a chart tries.

#include "systems/shadows/technique_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tools/gnomon/chart_settings.hpp"
#include "tools/gnomon/view_options.hpp"

namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::IsSubsetOf;
using testing::Not;

TEST(ChartSettings, AreWordsThatTheCommandLineReads) {
    const auto techniques = shadows::all_techniques();

    for (const bool soft : {false, true})
        for (const std::string& word : gnomon::settings_to_try(techniques, soft, false)) {
            const auto read = gnomon::options_from_word(word, techniques);
            EXPECT_TRUE(read) << word << ": " << to_string(read.error());
        }
}

TEST(ChartSettings, TryEveryTechniqueAtLeastOnce) {
    const auto techniques = shadows::all_techniques();
    std::set<std::string> tried;
    for (const std::string& word : gnomon::settings_to_try(techniques, false, true))
        for (const scene::LightKind kind :
             {scene::LightKind::directional, scene::LightKind::spot, scene::LightKind::point})
            tried.insert(
                gnomon::options_from_word(word, techniques)->wish(kind).technique.value_or("auto"));

    for (const auto& technique : techniques)
        EXPECT_THAT(tried, Contains(std::string(technique->traits().name)));
    EXPECT_THAT(tried, Contains("auto"));
}

TEST(ChartSettings, GoThroughSizesFiltersProxiesWaysAndBudgets) {
    const auto words = gnomon::settings_to_try(shadows::all_techniques(), false, false);

    EXPECT_THAT(
        words,
        AllOf(
            Contains("map@256:nearest"),
            Contains("map@4096:pcf"),
            Contains("shadow_texture@256"),
            Contains("shadow_texture@4096"),
            Contains("volume@0"),
            Contains("volume@3"),
            Contains("planar:texture"),
            Contains("auto@0.1"),
            Contains("auto@8")));
    EXPECT_EQ(std::set<std::string>(words.begin(), words.end()).size(), words.size());
}

TEST(ChartSettings, AddSamplesAndSoftFiltersForSoftLightsAlone) {
    const auto techniques = shadows::all_techniques();

    EXPECT_THAT(
        gnomon::settings_to_try(techniques, true, false),
        AllOf(Contains("planar@16"), Contains("map@1024:pcss")));
    EXPECT_THAT(
        gnomon::settings_to_try(techniques, false, false),
        AllOf(Not(Contains("planar@16")), Not(Contains("map@1024:pcss"))));
}

TEST(ChartSettings, AreFewerAndAmongTheOthersWhenQuick) {
    const auto techniques = shadows::all_techniques();
    const auto all = gnomon::settings_to_try(techniques, false, false);
    const auto quick = gnomon::settings_to_try(techniques, false, true);

    EXPECT_THAT(quick, IsSubsetOf(all));
    EXPECT_LT(quick.size() * 2, all.size());
}

TEST(ChartSettings, OfOneFamilyDifferInSizeAlone) {
    EXPECT_EQ(gnomon::chart_setting("map@1024:pcf").series, "map");
    EXPECT_EQ(gnomon::chart_setting("map@1024:pcf").family, "map:pcf");
    EXPECT_EQ(gnomon::chart_setting("map@256x2:pcf").family, "mapx2:pcf");
    EXPECT_EQ(gnomon::chart_setting("volume@3").family, "volume");
    EXPECT_EQ(gnomon::chart_setting("planar:box").series, "planar");
    EXPECT_EQ(gnomon::chart_setting("planar:box").family, "");
    EXPECT_EQ(gnomon::chart_setting("blob").family, "");
}

TEST(ChartSettings, OfAutoAreKnownByTheirBudget) {
    EXPECT_EQ(gnomon::chart_setting("auto@0.25").budget_px, 0.25);
    EXPECT_EQ(gnomon::chart_setting("auto@0.25").family, "");
    EXPECT_FALSE(gnomon::chart_setting("auto").budget_px);
    EXPECT_FALSE(gnomon::chart_setting("volume@2").budget_px);
}

} // namespace
