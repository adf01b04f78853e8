// The command line as other tools rely on it: files, words and exit codes. Runs the program itself.

#include "engine/core/image.hpp"
#include "tests/support/programs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace {

using test_support::Outcome;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kLevel = R"(
local g = require "gnomon"
return g.scene {
  g.sun { name = "sun", direction = { 0.5, -1, -0.4 } },
  g.lamp { name = "lamp 1", position = { 1.5, 2, 0 }, intensity = 30, range = 8 },
  g.model { name = "floor", shape = "box", size = { 20, 0.2, 20 }, position = { 0, -0.1, 0 } },
  g.model { name = "box", shape = "box", size = { 1, 1, 1 }, position = { 0, 0.5, 0 } },
  g.camera { name = "front", position = { 0, 3, 6 }, look_at = { 0, 0, 0 } },
}
)";

Outcome run(const std::string& arguments) {
    return test_support::run(fmt::format("'{}' {}", GNOMON_PROGRAM, arguments));
}

class CommandLine : public test_support::TestWithFolder {
protected:
    void SetUp() override { write("level.lua", kLevel); }

    [[nodiscard]] nlohmann::json json(const std::string& name) const {
        std::ifstream stream(folder_ / name);
        return nlohmann::json::parse(stream);
    }
    /// Skips the test where there is no OpenGL.
    Outcome run_gl(const std::string& arguments) const {
        Outcome outcome = run(arguments);
        if (outcome.code == 77) skipped_ = true;
        return outcome;
    }

    mutable bool skipped_ = false;
};

#define SKIP_WITHOUT_GL()                                                                          \
    if (skipped_) GTEST_SKIP() << "no OpenGL here"

TEST_F(CommandLine, AnUnknownOptionIsRefusedWithTheNearest) {
    const Outcome outcome = run("render x.glb --framse 3");

    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("--framse"));
    EXPECT_THAT(outcome.text, HasSubstr("did you mean '--frames'?"));
}

TEST_F(CommandLine, AnUnknownCommandIsRefusedWithTheNearest) {
    const Outcome outcome = run("rendr x.glb");

    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("did you mean 'render'?"));
}

TEST_F(CommandLine, WrongValuesAreWrongUsage) {
    for (const std::string options :
         {"--size 12",
          "--size 0x5",
          "--technique volumee",
          "--refresh sometimes",
          "--map-size -3",
          "--camera nowhere"}) {
        SCOPED_TRACE(options);
        const Outcome outcome =
            run_gl(fmt::format("render {} {} --out {}", path("level.lua"), options, path("out")));
        SKIP_WITHOUT_GL();
        EXPECT_EQ(outcome.code, 2) << outcome.text;
    }
}

TEST_F(CommandLine, ABrokenSceneExitsWithThreeAndItsPlace) {
    write(
        "broken.lua",
        "local g = require \"gnomon\"\nreturn g.scene {\n  g.sun { name = \"sun\", directon = { 0, "
        "-1, 0 } },\n}\n");

    const Outcome outcome = run("check " + path("broken.lua"));

    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.text, HasSubstr("broken.lua:3:"));
    EXPECT_THAT(outcome.text, HasSubstr("direction"));
}

TEST_F(CommandLine, AMissingFileAndAStrangeOneExitWithThree) {
    EXPECT_EQ(run("check " + path("nothing.glb")).code, 3);
    write("notes.txt", "hello");
    EXPECT_EQ(run("check " + path("notes.txt")).code, 3);
}

TEST_F(CommandLine, RenderLeavesEveryFileOfItsContract) {
    const Outcome outcome = run_gl(fmt::format(
        "render {} --size 160x120 --technique none --frames 4 --warmup 1 --seconds 5 --out {}",
        path("level.lua"),
        path("out")));
    SKIP_WITHOUT_GL();

    ASSERT_EQ(outcome.code, 0) << outcome.text;
    for (const std::string name : {"color", "ids", "mask_sun", "mask_lamp_1"}) {
        SCOPED_TRACE(name);
        const auto image = engine::read_png(folder_ / "out" / (name + ".png"));
        ASSERT_TRUE(image);
        EXPECT_EQ(image->width, 160);
        EXPECT_EQ(image->height, 120);
    }
    const auto stats = json("out/stats.json");
    EXPECT_EQ(stats["frames"], 4);
    EXPECT_EQ(stats["size"], nlohmann::json({160, 120}));
    for (const std::string kind : {"with", "without"})
        for (const std::string figure : {"median_ms", "min_ms", "p99_ms"})
            EXPECT_GT(stats[kind][figure].get<double>(), 0.0);
    EXPECT_FALSE(stats["renderer"].get<std::string>().empty());
    EXPECT_GE(stats["passes"].size(), 2U);
    EXPECT_GT(stats["counters"]["triangles"].get<int>(), 0);
    EXPECT_GT(stats["gpu_bytes"].get<int>(), 0);
    EXPECT_FALSE(json("out/plans.json")["pairs"].empty());
}

TEST_F(CommandLine, TracedMasksHoldShadowsAndNoneDoNot) {
    const auto dark_pixels = [&](const std::string& technique) {
        const Outcome outcome = run_gl(fmt::format(
            "render {} --size 160x120 --technique {} --out {}",
            path("level.lua"),
            technique,
            path("out")));
        if (skipped_) return 0;
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        const auto mask = engine::read_png(folder_ / "out" / "mask_sun.png");
        return static_cast<int>(std::count_if(
            mask->bytes.begin(), mask->bytes.end(), [](std::uint8_t v) { return v < 128; }));
    };

    const int traced = dark_pixels("traced");
    SKIP_WITHOUT_GL();
    EXPECT_GT(traced, 20);
    EXPECT_EQ(dark_pixels("none"), 0);
}

TEST_F(CommandLine, TheSameSceneHasTheSameHash) {
    const std::string arguments = fmt::format(
        "render {} --size 160x120 --technique traced --hash --out {}",
        path("level.lua"),
        path("out"));

    const Outcome first = run_gl(arguments);
    SKIP_WITHOUT_GL();

    EXPECT_THAT(first.text, HasSubstr("hash color.png "));
    EXPECT_EQ(first.text, run(arguments).text);
}

TEST_F(CommandLine, ATechniqueThatCannotServeSaysSoAndExitsWithFour) {
    const Outcome outcome = run_gl(fmt::format(
        "render {} --size 64x64 --technique spot_map --out {}", path("level.lua"), path("out")));
    SKIP_WITHOUT_GL();

    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.text, testing::StartsWith("unsupported:"));
}

TEST_F(CommandLine, MeasureHoldsTracedAtZeroAndNoneFarFromIt) {
    const Outcome outcome = run_gl(fmt::format(
        "measure {} --size 160x120 --technique traced,none --samples 16 --protocol still,walk,yaw "
        "--moving-frames 3 --out {}",
        path("level.lua"),
        path("out")));
    SKIP_WITHOUT_GL();

    ASSERT_EQ(outcome.code, 0) << outcome.text;
    const auto rows = json("out/measure.json")["rows"];
    ASSERT_EQ(rows.size(), 12U); // two lights, two techniques, three protocols
    for (const auto& row : rows) {
        if (row["protocol"] != "still") continue; // the others have figures of motion only
        const double error = row["mean_error"].get<double>();
        if (row["technique"] == "traced") {
            EXPECT_LT(error, 0.0015) << row["light"];
            EXPECT_EQ(row["flip_mean"], 0.0) << row["light"];
        } else {
            EXPECT_GT(error, 0.0015) << row["light"];
            EXPECT_GT(row["flip_mean"].get<double>(), 0.001) << row["light"];
        }
    }
    EXPECT_TRUE(fs::exists(folder_ / "out" / "measure.csv"));
}

TEST_F(CommandLine, MeasureMovesLightsCastersAndTheLevelItself) {
    write("moving.lua", R"(
local g = require "gnomon"
return g.scene {
  on_update = function() if g.world.time > 0.025 then g.world:find("torch").on = false end end,
  g.sun { name = "sun", direction = { 0.5, -1, -0.4 } },
  g.spot { name = "torch", position = { 1.5, 3, 0 }, target = { 0, 0, 0 }, intensity = 30 },
  g.model { name = "floor", shape = "box", size = { 20, 0.2, 20 }, position = { 0, -0.1, 0 } },
  g.model { name = "box", shape = "box", size = { 1, 1, 1 }, path = "way", path_speed = 2 },
  g.path { name = "way", points = { { 0, 0.5, -0.5 }, { 0, 0.5, 0.5 } } },
  g.camera { name = "front", position = { 0, 3, 6 }, look_at = { 0, 0, 0 } },
}
)");
    const Outcome outcome = run_gl(fmt::format(
        "measure {} --size 160x120 --technique none,volume,map@512%3 --samples 4 --moving-frames 4 "
        "--protocol sun,light,casters,play --out {}",
        path("moving.lua"),
        path("out")));
    SKIP_WITHOUT_GL();

    ASSERT_EQ(outcome.code, 0) << outcome.text;
    const nlohmann::json report = json("out/measure.json");
    ASSERT_EQ(report["rows"].size(), 24U) << "two lights, three techniques, four protocols";
    for (const auto& row : report["rows"]) {
        SCOPED_TRACE(fmt::format(
            "{} {} {}",
            row["light"].get<std::string>(),
            row["technique"].get<std::string>(),
            row["protocol"].get<std::string>()));
        if (row["light"] == "torch" && row["protocol"] == "play") {
            EXPECT_EQ(row["note"], "the light is off in frame 2");
            continue;
        }
        ASSERT_TRUE(row["crawl_px"].is_number());
        const bool moves = row["protocol"] == "casters" || row["protocol"] == "play"
                           || (row["protocol"] == "light") == (row["light"] == "torch");
        if (row["technique"] == "volume") {
            EXPECT_LT(row["crawl_px"].get<double>(), 0.02);
            EXPECT_EQ(row["stale_p95_px"], 0.0) << "it is redrawn whenever anything moves";
            EXPECT_EQ(row["age_max"], 0.0);
        } else if (row["technique"] == "map@512%3") {
            if (row["protocol"] != "casters") continue;
            EXPECT_EQ(row["age_max"], 2.0);
            if (row["light"] == "sun") {
                EXPECT_GT(row["stale_p95_px"].get<double>(), 0.5);
            }
        } else if (row["protocol"] != "sun") { // a fiftieth of a degree moves few pixels here
            EXPECT_EQ(row["crawl_px"].get<double>() > 0.01, moves);
        }
    }
}

TEST_F(CommandLine, CheckReportsHealthAndPlans) {
    const Outcome outcome = run("check " + path("level.lua"));

    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.text, HasSubstr("closed"));
    EXPECT_THAT(outcome.text, HasSubstr("pairs of light and receiver"));
}

TEST_F(CommandLine, ExplainGivesAReasonForEveryPair) {
    const Outcome table = run(fmt::format("explain {}", path("level.lua")));
    EXPECT_EQ(table.code, 0) << table.text;
    EXPECT_THAT(table.text, HasSubstr("cheapest within"));

    const Outcome pinned = run(fmt::format("explain {} --technique map@512", path("level.lua")));
    EXPECT_EQ(pinned.code, 0) << pinned.text;
    EXPECT_THAT(pinned.text, HasSubstr("pinned"));

    const Outcome unknown = run(fmt::format("explain {} --pair sun,nobody", path("level.lua")));
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.text, HasSubstr("no such pair"));
}

TEST_F(CommandLine, ATechniqueMayNameItsSetting) {
    EXPECT_EQ(run(fmt::format("explain {} --technique map@much", path("level.lua"))).code, 2);
    EXPECT_EQ(run(fmt::format("explain {} --technique auto@0.5", path("level.lua"))).code, 0);
    EXPECT_EQ(run(fmt::format("explain {} --technique volume@2", path("level.lua"))).code, 0);
    EXPECT_EQ(run(fmt::format("explain {} --technique volume@9", path("level.lua"))).code, 2);
}

TEST_F(CommandLine, ASoakTellsWhatItHolds) {
    const Outcome outcome =
        run_gl(fmt::format("play {} --seconds 1 --size 64x48", path("level.lua")));
    SKIP_WITHOUT_GL();

    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("15 frames"));
    EXPECT_THAT(outcome.text, HasSubstr("nothing grew"));
}

TEST_F(CommandLine, AMistakeWhilePlayingIsToldOnceAndTheLevelGoesOn) {
    write(
        "acting.lua",
        "local g = require \"gnomon\"\nreturn g.scene { on_update = function() "
        "error(\"no more\") end,\n  g.model { shape = \"box\" } }\n");

    const Outcome outcome =
        run_gl(fmt::format("play {} --seconds 0.5 --size 64x48", path("acting.lua")));
    SKIP_WITHOUT_GL();

    EXPECT_EQ(outcome.code, 0) << outcome.text;
    const std::size_t first = outcome.text.find("acting.lua:2: no more");
    ASSERT_NE(first, std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.text.find("acting.lua:2: no more", first + 1), std::string::npos);
    EXPECT_THAT(outcome.text, HasSubstr("stack traceback"));
}

TEST_F(CommandLine, PlayWithoutADisplayLeavesPicturesAndAPage) {
    const Outcome outcome = run_gl(fmt::format(
        "play {} --headless --size 64x48 --walk-seconds 0.5 --out {}",
        path("level.lua"),
        path("out")));
    SKIP_WITHOUT_GL();

    ASSERT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_TRUE(fs::exists(folder_ / "out" / "index.html"));
    EXPECT_THAT(outcome.text, HasSubstr("pictures"));
}

TEST_F(CommandLine, AnInterruptedMeasurementGoesOnWhereItStopped) {
    const std::string command = fmt::format(
        "measure {} --size 64x48 --technique none,map@64,volume --protocol still,casters "
        "--moving-frames 3 --samples 4 --out {}",
        path("level.lua"),
        path("out"));
    const auto text_of = [&](const char* name) {
        std::stringstream buffer;
        buffer << std::ifstream(folder_ / "out" / name, std::ios::binary).rdbuf();
        return buffer.str();
    };
    const Outcome whole = run_gl(command);
    SKIP_WITHOUT_GL();
    ASSERT_EQ(whole.code, 0) << whole.text;
    EXPECT_THAT(whole.text, testing::Not(HasSubstr("measured before")));
    const std::string rows = text_of("measure.rows.jsonl");
    const std::string csv = text_of("measure.csv");
    const std::string report = text_of("measure.json");
    ASSERT_EQ(std::count(rows.begin(), rows.end(), '\n'), 12) << "2 lights, 2 protocols";

    // Ended in the middle of the eighth row.
    std::size_t seven = 0;
    for (int line = 0; line < 7; ++line)
        seven = rows.find('\n', seven) + 1;
    write("out/measure.rows.jsonl", rows.substr(0, seven + 100));
    const Outcome rest = run_gl(command);

    ASSERT_EQ(rest.code, 0) << rest.text;
    EXPECT_THAT(rest.text, HasSubstr("measure.rows.jsonl:8: the last line is not whole"));
    EXPECT_THAT(rest.text, HasSubstr("7 of 12 rows were measured before"));
    EXPECT_EQ(text_of("measure.csv"), csv);
    EXPECT_EQ(text_of("measure.json"), report);
    EXPECT_EQ(text_of("measure.rows.jsonl"), rows);
    EXPECT_THAT(run_gl(command).text, HasSubstr("12 of 12 rows were measured before"));
    EXPECT_THAT(run_gl(command + " --fresh").text, testing::Not(HasSubstr("measured before")));
}

} // namespace
