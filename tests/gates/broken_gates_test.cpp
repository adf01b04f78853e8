// A gate sees what is over its limit, and says where to look.

#include "tests/gates/gates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gates {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

measure::Row row_with(const Promise& promised, const Gate& gate, double value) {
    measure::Row row;
    row.scene = promised.scene;
    row.light = "sun";
    row.technique = promised.technique;
    row.protocol = gate.protocol;
    row.figures.emplace();
    row.motion.emplace();
    for (const auto& column : measure::columns_of<measure::Figures>())
        if (column.name == gate.figure) column.access.set(*row.figures, value);
    for (const auto& column : measure::columns_of<measure::MotionFigures>())
        if (column.name == gate.figure) column.access.set(*row.motion, value);
    return row;
}

TEST(BrokenGates, EveryGateHoldsAtItsLimitAndBreaksOverIt) {
    for (const Promise& promised : promises())
        for (const Gate& gate : promised.gates) {
            const Promise alone = {promised.scene, promised.technique, {gate}};
            const double over = gate.at_most * 1.001 + 0.001;

            EXPECT_THAT(
                broken_gates(alone, std::vector{row_with(promised, gate, gate.at_most)}), IsEmpty())
                << gate.figure;
            EXPECT_THAT(broken_gates(alone, std::vector{row_with(promised, gate, over)}), SizeIs(1))
                << gate.figure;
        }
}

TEST(BrokenGates, SayWhatWasFoundAndHowToSeeIt) {
    const Gate gate = {"walk", "flicker_ratio", 1.0, "as still as the truth"};
    const Promise promised = {"yard", "volume", {gate}};

    const auto broken = broken_gates(promised, std::vector{row_with(promised, gate, 1.5)});

    ASSERT_THAT(broken, SizeIs(1));
    EXPECT_THAT(
        broken[0].sentence,
        HasSubstr("yard, light 'sun', volume, walk: flicker_ratio is 1.5, expected at most 1 (as "
                  "still as the truth)"));
    EXPECT_THAT(broken[0].sentence, HasSubstr("gnomon measure tests/gates/scenes/yard.lua"));
    EXPECT_THAT(broken[0].sentence, HasSubstr("--technique volume --protocol walk"));
}

TEST(BrokenGates, AFigureThatIsMissingBreaksItsGate) {
    const Gate gate = {"still", "eps_px", 1.0, "any"};
    const Promise promised = {"yard", "volume", {gate}};
    measure::Row row;
    row.technique = "volume";
    row.note = "outside its domain";

    const auto broken = broken_gates(promised, std::vector{row});

    ASSERT_THAT(broken, SizeIs(1));
    EXPECT_THAT(broken[0].sentence, HasSubstr("eps_px is missing (outside its domain)"));
}

} // namespace
} // namespace gates
