// What auto picks lies on the front of cost against error, of every light of the committed scenes.
// Costs are predicted ones, which follow from counts alone.

#include "tests/gates/gates.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tools/chart/beaten_picks.hpp"
#include "tools/gnomon/charting.hpp"
#include "tools/gnomon/studio.hpp"

namespace gates {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;

class Front : public testing::TestWithParam<std::string> {};

/// Disabled: the picker takes the cheapest technique that its error model allows, and both models
/// are still to be fitted to what is measured. It is switched on together with that picker.
TEST_P(Front, DISABLED_HoldsWhatIsPicked) {
    auto studio = gnomon::Studio::open(kWidth, kHeight);
    if (!studio) GTEST_SKIP() << "no OpenGL here";
    auto level = gnomon::load_level(
        fmt::format("{}/tests/gates/scenes/{}.lua", PROJECT_SOURCE_DIR, GetParam()));
    ASSERT_TRUE(level) << engine::to_string(level.error());
    const auto camera = gnomon::choose_camera(*level, "", kWidth, kHeight);
    ASSERT_TRUE(camera);
    const bool soft = GetParam() == "soft";
    gnomon::ChartingOptions options;
    options.words = gnomon::settings_to_try((*studio)->shadows().techniques(), soft, true);
    options.timing.frames = 0;
    options.truth_samples = 64;

    const auto charts = gnomon::chart_level(**studio, *level, *camera, options, {});

    ASSERT_TRUE(charts) << engine::to_string(charts.error());
    for (const chart::Chart& chart : *charts)
        for (const std::string& beaten :
             chart::beaten_picks(chart, chart::Across::predicted, chart::usual_up(*charts)))
            ADD_FAILURE() << beaten;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Front, testing::ValuesIn(scenes()), [](const testing::TestParamInfo<std::string>& one) {
        return one.param;
    });

} // namespace
} // namespace gates
