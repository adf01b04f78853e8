// Deliberately wrong remedies: each moves exactly the figures that are meant to see it beyond their
// gates, and leaves the others where they were. Prints a table of all figures, right and wrong, and
// keeps it as wrong_remedies.md in the folder of GNOMON_RESULTS, where that is set.

#include "tests/gates/results_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "tools/gnomon/studio.hpp"

namespace gates {
namespace {

using shadows::Remedy;

/// How wrong a still picture is.
const std::set<std::string> kAccuracy = {
    "false_shadow_far_px", "light_leak_far_px", "false_shadow_in_px", "light_leak_in_px", "eps_px"};
/// A wrong shape has edges of its own, which move as the true ones do not: these may follow. What
/// changes while nothing moves, and what is drawn too late, never does.
const std::set<std::string> kMayFollow = {"flicker_ratio", "crawl_px", "pop"};

struct WrongRemedy {
    Remedy remedy;
    std::string wrong; ///< what is done instead
    std::string scene;
    std::string technique;
    /// Figures that must break a gate. Of kAccuracy no other may; where none of kAccuracy is meant,
    /// no other figure at all.
    std::set<std::string> meant;
};

std::vector<WrongRemedy> wrong_remedies() {
    const std::string coarse = "cascaded_map@256x1";
    const std::string blocks = "cascaded_map@64x4:nearest";
    const std::set<std::string> dark = {"false_shadow_far_px", "eps_px"};
    const std::set<std::string> dark_inside = {
        "false_shadow_far_px", "false_shadow_in_px", "eps_px"};
    return {
        {Remedy::map_no_normal_offset,
         "look-ups moved two texels along the normal",
         "yard",
         coarse,
         {"eps_px"}},
        {Remedy::map_snapped_texels,
         "maps follow the camera by less than a texel",
         "field",
         blocks,
         {"flicker_ratio", "pop"}},
        {Remedy::map_constant_size,
         "maps fitted to what each frame sees",
         "field",
         blocks,
         {"flicker_ratio"}},
        {Remedy::map_receiver_plane, "one depth for all texels of a filter", "yard", coarse, dark},
        {Remedy::map_fine_depth,
         "eight bits of depth",
         "torch",
         "spot_map@1024",
         {"light_leak_far_px", "eps_px"}},
        {Remedy::planar_anti_shadow_clip,
         "what is above the lamp is projected too",
         "clipped",
         "planar",
         dark_inside},
        {Remedy::planar_behind_clip,
         "what is under the floor is projected too",
         "clipped",
         "planar",
         dark_inside},
        {Remedy::soft_width,
         "one filter width for every height",
         "soft",
         "cube_map@1024:pcss",
         dark},
        {Remedy::texture_light_points,
         "one point for the whole light",
         "soft",
         "shadow_texture@64",
         {"eps_px"}},
        {Remedy::texture_plane_depth,
         "a caster's depth without its slope",
         "yard",
         "shadow_texture",
         dark},
        {Remedy::volume_equal_depth,
         "a volume's lid counts on its own caster",
         "yard",
         "volume",
         dark_inside},
        {Remedy::blob_along_light, "an ellipse straight below", "flat", "blob", dark},
    };
}

/// What GoogleTest says of one.
void PrintTo(const WrongRemedy& one, std::ostream* out) {
    *out << one.wrong << " (" << shadows::name_of(one.remedy) << ")";
}

MarkdownTable empty_table() {
    std::vector<std::string> titles = {"wrong", "scene, technique", "meant to see it"};
    for (const ShownFigure& shown : shown_figures())
        titles.push_back(shown.title);
    return MarkdownTable(titles);
}

class WrongRemedies : public testing::TestWithParam<WrongRemedy> {
protected:
    static void SetUpTestSuite() { table_.emplace(empty_table()); }
    static void TearDownTestSuite() {
        fmt::print("{}", table_->text());
        const auto kept = keep_result("wrong_remedies", table_->text());
        EXPECT_TRUE(kept) << engine::to_string(kept.error());
    }
    void SetUp() override {
        if (!gnomon::Studio::open(16, 16)) GTEST_SKIP() << "no OpenGL here";
    }

    static std::optional<MarkdownTable> table_;
};

std::optional<MarkdownTable> WrongRemedies::table_;

std::set<std::string> figures_of(const std::vector<Broken>& broken) {
    std::set<std::string> figures;
    for (const Broken& one : broken)
        figures.insert(one.gate.figure);
    return figures;
}

bool is_inaccurate(const WrongRemedy& wrong) {
    return std::any_of(wrong.meant.begin(), wrong.meant.end(), [](const std::string& figure) {
        return kAccuracy.contains(figure);
    });
}

/// Right and wrong in one row: "0.2 to 0.9", in bold where a gate breaks.
std::vector<std::string> table_row(
    const WrongRemedy& wrong,
    const Promise& promised,
    std::span<const measure::Row> right_rows,
    std::span<const measure::Row> wrong_rows,
    const std::set<std::string>& broken) {
    std::vector<std::string> cells = {
        fmt::format("{}: `{}` off", wrong.wrong, shadows::name_of(wrong.remedy)),
        fmt::format("{}, `{}`", wrong.scene, wrong.technique),
        fmt::format("{}", fmt::join(wrong.meant, ", "))};
    for (const ShownFigure& shown : shown_figures()) {
        const std::string before = cell(worst(promised, right_rows, shown.figure));
        const std::string after = cell(worst(promised, wrong_rows, shown.figure));
        const bool bold = broken.contains(shown.figure);
        cells.push_back(
            before == after
                ? before
                : fmt::format("{} to {}{}{}", before, bold ? "**" : "", after, bold ? "**" : ""));
    }
    return cells;
}

TEST_P(WrongRemedies, AreSeenByTheFiguresThatAreMeantToAndByNoOthers) {
    const WrongRemedy& wrong = GetParam();
    const Promise& promised = promise(wrong.scene, wrong.technique);
    const auto right_rows = measure_promises({&promised, 1});
    ASSERT_TRUE(right_rows) << engine::to_string(right_rows.error());
    const auto wrong_rows =
        measure_promises({&promised, 1}, shadows::Remedies().without(wrong.remedy));
    ASSERT_TRUE(wrong_rows) << engine::to_string(wrong_rows.error());
    const std::vector<Broken> broken = broken_gates(promised, *wrong_rows);
    const std::set<std::string> figures = figures_of(broken);
    table_->add(table_row(wrong, promised, *right_rows, *wrong_rows, figures));

    EXPECT_TRUE(broken_gates(promised, *right_rows).empty());
    for (const std::string& meant : wrong.meant)
        EXPECT_TRUE(figures.contains(meant)) << meant << " did not see it";
    for (const Broken& one : broken)
        EXPECT_TRUE(
            wrong.meant.contains(one.gate.figure)
            || (is_inaccurate(wrong) && kMayFollow.contains(one.gate.figure)))
            << one.sentence;
}

INSTANTIATE_TEST_SUITE_P(
    Remedies,
    WrongRemedies,
    testing::ValuesIn(wrong_remedies()),
    [](const testing::TestParamInfo<WrongRemedy>& one) {
        return std::string(shadows::name_of(one.param.remedy));
    });

} // namespace
} // namespace gates
