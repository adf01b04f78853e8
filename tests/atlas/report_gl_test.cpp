// What a run of the atlas leaves: measured curves in tables and on a page that needs nothing else.

#include "tests/atlas/cases.hpp"
#include "tests/atlas/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "tools/gnomon/studio.hpp"

namespace atlas {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A made-up case of three steps, whose pictures are a pixel large.
Outcome made_up() {
    Outcome one;
    one.id = "X1";
    one.sentence = "what is < 1 is \"dark\"";
    one.remedy = "map_receiver_plane";
    one.steps = {0.0, 1.5, 3.0};
    one.worst = 1;
    one.curves = {{"false shadow, px", 4.0, {1.0, 77.5, 2.0}, {0.0, 4.0, 0.5}}};
    one.with = one.without = one.truth = engine::Image(1, 1, 1);
    return one;
}

TEST(Sweep, HoldsItsWorstStepAmongEvenOnes) {
    const auto steps = steps_of({0.0, 4.0, 1.2}, 5);

    EXPECT_THAT(steps, testing::ElementsAre(0.0, 1.2, 2.0, 3.0, 4.0));
}

TEST(Sweep, OfADescendingParameterRises) {
    EXPECT_THAT(steps_of({3.0, 1.0, 3.0}, 3), testing::ElementsAre(1.0, 2.0, 3.0));
}

TEST(AtlasVerdict, IsGoodWhenTheRemedyHoldsAndItsLackFails) {
    EXPECT_EQ(made_up().verdict(), "holds");
}

TEST(AtlasVerdict, TellsARemedyThatHelpsNothing) {
    Outcome idle = made_up();
    idle.curves[0].off[1] = 3.0; // the worst step alone decides

    EXPECT_FALSE(idle.good());
    EXPECT_EQ(idle.verdict(), "nothing fails with the remedy off");
}

TEST(AtlasVerdict, TellsAGateThatBreaksAnywhere) {
    Outcome broken = made_up();
    broken.curves[0].on[2] = 4.5;

    EXPECT_FALSE(broken.good());
    EXPECT_EQ(broken.verdict(), "broken with the remedy on");
}

TEST(AtlasVerdict, OfWhatIsNoNumberIsBroken) {
    Outcome broken = made_up();
    broken.curves[0].on[0] = std::nan("");

    EXPECT_EQ(broken.verdict(), "broken with the remedy on");
}

TEST(AtlasReport, ListsEveryPointOfEveryCurve) {
    const Findings found{{made_up()}, {}, {}};

    EXPECT_THAT(csv(found), HasSubstr("X1,map_receiver_plane,\"false shadow, px\",4,1.5,77.5,4\n"));
    const auto parsed = nlohmann::json::parse(json(found));
    EXPECT_EQ(parsed["cases"][0]["curves"][0]["off"][1], 77.5);
    EXPECT_EQ(parsed["cases"][0]["verdict"], "holds");
}

TEST(AtlasReport, CountsWhatHoldsWhatIsRefusedAndWhatCannotOccur) {
    Outcome broken = made_up();
    broken.curves[0].on[2] = 4.5;
    const Findings found{{made_up(), broken}, refusals(), {{"X3", "goes wrong", "cannot"}}};

    const std::string summary =
        fmt::format("1 of 2 cases hold, {} are refused, 1 cannot occur", refusals().size());
    EXPECT_THAT(text_table(found), HasSubstr(summary));
    EXPECT_THAT(markdown_table(found), HasSubstr("| X3 | goes wrong | cannot |"));
}

TEST(AtlasPage, NeedsNothingFromElsewhere) {
    const std::string page = html_page({{made_up()}, refusals(), impossible()});

    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, Not(HasSubstr("src=\"/")));
    EXPECT_THAT(page, Not(HasSubstr("<link")));
    EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,iVBORw0KGgo"));
}

TEST(AtlasPage, ShowsCurvesGateAndVerdict) {
    const std::string page = html_page({{made_up()}, {}, {}});

    // 44 + 276 / 2 across, 140 - 124 up: the highest point of all.
    EXPECT_THAT(page, HasSubstr("<title>off at 1.5: 77.5</title>"));
    EXPECT_THAT(page, HasSubstr("182.0,16.0 "));
    EXPECT_THAT(page, HasSubstr("class=\"gate\""));
    EXPECT_THAT(page, HasSubstr("<span class=\"good\">holds</span>"));
    EXPECT_THAT(page, HasSubstr("what is &lt; 1 is &quot;dark&quot;"));
}

TEST(AtlasSweep, MeasuresOffAndOnAndKeepsTheMasks) {
    if (!gnomon::Studio::open(kPictureSize, kPictureSize)) GTEST_SKIP() << "no OpenGL here";
    std::vector<Case> cases = blob_cases();
    int steps = 0;

    const Outcome one = run_sweep(cases.front(), 2, [&] { ++steps; });

    EXPECT_EQ(steps, 2);
    EXPECT_EQ(one.problem, "");
    EXPECT_EQ(one.curves.front().off.size(), 2U);
    EXPECT_TRUE(one.good()) << one.verdict();
    EXPECT_EQ(one.truth.width, kPictureSize);
    EXPECT_NE(one.without.bytes, one.with.bytes);
}

} // namespace
} // namespace atlas
