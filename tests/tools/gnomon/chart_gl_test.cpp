// gnomon chart on a small level with two lights: what it measures, what it leaves.

#include "tests/support/programs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Chart : public test_support::TestWithFolder {
protected:
    void SetUp() override { write("level.lua", test_support::kTwoLights); }

    /// @return the exit code; what it printed is in text_
    int run(const std::string& options) {
        const test_support::Outcome outcome = test_support::run(fmt::format(
            "'{}' chart '{}' --size 160x90 {}", GNOMON_PROGRAM, path("level.lua"), options));
        text_ = outcome.text;
        return outcome.code;
    }
    int chart(const std::string& options, const std::string& out = "out") {
        return run(fmt::format("{} --out '{}'", options, (folder_ / out).string()));
    }
    [[nodiscard]] std::string text(const std::string& file) const {
        std::ifstream stream(folder_ / file, std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }
    [[nodiscard]] nlohmann::json charts() const {
        return nlohmann::json::parse(text("out/chart.json"))["charts"];
    }

    std::string text_;
};

constexpr int kNoOpenGl = 77;

/// A point of a chart by its name.
nlohmann::json point(const nlohmann::json& chart, const std::string& name) {
    for (const nlohmann::json& point : chart["points"])
        if (point["point"] == name) return point;
    return nlohmann::json::object();
}

TEST_F(Chart, OfPredictedCostsIsTheSameEveryTime) {
    const std::string options = "--cost predicted --technique none,map@256:pcf,auto@1";
    const int code = chart(options, "once");
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;
    ASSERT_EQ(chart(options, "twice"), 0) << text_;

    EXPECT_EQ(text("once/chart.json"), text("twice/chart.json"));
    EXPECT_EQ(text("once/chart.html"), text("twice/chart.html"));
    EXPECT_NE(text("once/chart.html"), "");
}

TEST_F(Chart, KnowsThatTheTruthIsRightAndNothingIsFree) {
    const int code = chart("--frames 1 --technique none,map@256:pcf,map@1024:pcf,traced");
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;

    const auto lamp = charts()[1];
    EXPECT_EQ(lamp["light"], "lamp");
    EXPECT_EQ(point(lamp, "none")["predicted_ms"], 0.0);
    EXPECT_GT(point(lamp, "none")["wrong_percent"].get<double>(), 1.0);
    EXPECT_EQ(point(lamp, "traced")["wrong_percent"], 0.0);
    EXPECT_EQ(point(lamp, "traced")["front"], false);
    EXPECT_LT(point(lamp, "map@1024:pcf")["error_px"], point(lamp, "map@256:pcf")["error_px"]);
    EXPECT_GT(
        point(lamp, "map@1024:pcf")["predicted_ms"], point(lamp, "map@256:pcf")["predicted_ms"]);
    EXPECT_TRUE(point(lamp, "map@256:pcf")["measured_ms"].is_number());
}

TEST_F(Chart, OfTheSceneIsTheSumOfItsLights) {
    const int code = chart("--cost predicted --technique none,map@512:pcf");
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;

    const auto all = charts();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0]["light"], "");
    for (const char* figure : {"predicted_ms", "error_px"}) {
        SCOPED_TRACE(figure);
        EXPECT_NEAR(
            point(all[0], "map@512:pcf")[figure].get<double>(),
            point(all[1], "map@512:pcf")[figure].get<double>()
                + point(all[2], "map@512:pcf")[figure].get<double>(),
            1e-9);
    }
}

TEST_F(Chart, ChargesALightWithItsOwnShadowsAlone) {
    const int code = chart("--cost predicted --technique map@1024:pcf");
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;

    // Six faces for the lamp. The sun's cascades are fewer.
    const auto texels = [&](int chart) {
        return std::stod(
            point(charts()[chart], "map@1024:pcf")["facts"]["map texels"].get<std::string>());
    };
    EXPECT_LT(texels(2), texels(1));
}

TEST_F(Chart, SaysWhyASettingHasNoPoint) {
    const int code = chart("--cost predicted --technique none,cube_map@256");
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;

    const auto sun = charts()[2];
    EXPECT_EQ(sun["light"], "sun");
    ASSERT_EQ(sun["refusals"].size(), 1U);
    EXPECT_EQ(sun["refusals"][0]["name"], "cube_map@256");
    EXPECT_THAT(
        sun["refusals"][0]["reason"].get<std::string>(),
        testing::StartsWith("cube_map on receiver '"));
    EXPECT_THAT(sun["refusals"][0]["reason"].get<std::string>(), Not(HasSubstr("not pinned")));
    EXPECT_EQ(charts()[0]["refusals"][0]["name"], "cube_map@256");
}

TEST_F(Chart, OfOneLightIsTheSameAsAmongAll) {
    const int code = chart("--cost predicted --technique map@256:pcf");
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;
    const auto among_all = charts()[2];

    ASSERT_EQ(chart("--cost predicted --technique map@256:pcf --light sun"), 0) << text_;

    ASSERT_EQ(charts().size(), 1U);
    EXPECT_EQ(charts()[0]["light"], "sun");
    EXPECT_EQ(charts()[0]["points"], among_all["points"]);
}

TEST_F(Chart, LaysOtherEnginesOverTheScene) {
    std::ofstream(folder_ / "peers.csv")
        << "scene,peer,config,cost,wrong\nlevel,ogre,pcf,3,0.5\nelsewhere,ogre,pcf,4,0.5\n";
    const int code = chart(fmt::format(
        "--cost predicted --technique none --overlay '{}'", (folder_ / "peers.csv").string()));
    if (code == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    ASSERT_EQ(code, 0) << text_;

    EXPECT_EQ(point(charts()[0], "ogre pcf")["measured_ms"], 3.0);
    EXPECT_EQ(charts()[0]["points"].size(), 2U);
    EXPECT_EQ(charts()[1]["points"].size(), 1U);
}

TEST_F(Chart, RefusesWhatItCannotRead) {
    std::ofstream(folder_ / "bad.csv") << "scene,peer\na,b\n";

    const int unknown = chart("--technique volumee");
    if (unknown == kNoOpenGl) GTEST_SKIP() << "no OpenGL here";
    EXPECT_EQ(unknown, 2);
    EXPECT_THAT(text_, HasSubstr("did you mean 'volume'?"));
    EXPECT_EQ(chart("--light sum"), 2);
    EXPECT_THAT(text_, HasSubstr("did you mean 'sun'?"));
    EXPECT_EQ(chart("--overlay /nowhere/x.csv"), 3);
    EXPECT_THAT(text_, HasSubstr("/nowhere/x.csv"));
    EXPECT_EQ(chart(fmt::format("--overlay '{}'", (folder_ / "bad.csv").string())), 3);
    EXPECT_THAT(text_, HasSubstr("column 'config' is missing"));
}

} // namespace
