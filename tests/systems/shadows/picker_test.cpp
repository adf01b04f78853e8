#include "systems/shadows/picker.hpp"
#include "systems/shadows/plan_json.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace shadows {
namespace {

using testing::HasSubstr;

/// A technique that predicts what it is told.
class Fake final : public ShadowTechnique {
public:
    Fake(std::string_view name, double error_px, double fragments, bool automatic = true)
        : traits_{name, "fake", automatic},
          error_px_(error_px),
          fragments_(fragments) {}

    static std::unique_ptr<ShadowTechnique> refusing(std::string_view name) {
        return std::make_unique<Fake>(name, -1.0, 0.0);
    }

    [[nodiscard]] const TechniqueTraits& traits() const override { return traits_; }
    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView&, const CasterGroup&) const override {
        if (error_px_ < 0.0) return engine::Error{"the receiver is not flat"};
        Prediction prediction;
        prediction.error_px = error_px_;
        prediction.cost.colour_fragments = fragments_;
        return prediction;
    }
    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override { return nullptr; }

private:
    TechniqueTraits traits_;
    double error_px_;
    double fragments_;
};

Techniques some_techniques() {
    Techniques techniques;
    techniques.push_back(std::make_unique<Fake>("exact", 0.0, 1e6));
    techniques.push_back(std::make_unique<Fake>("good", 0.5, 1e5));
    techniques.push_back(std::make_unique<Fake>("poor", 5.0, 1e3));
    techniques.push_back(Fake::refusing("planar"));
    techniques.push_back(std::make_unique<Fake>("truth", 0.0, 0.0, false));
    return techniques;
}

Plan pick_one(const ShadowScene& scene, const ShadowSettings& settings) {
    const FramePlan plan = pick(scene, settings, some_techniques(), llvmpipe_profile());
    EXPECT_EQ(plan.plans.size(), 1U);
    return plan.plans.front();
}

std::string reason_for(const Plan& plan, const std::string& technique) {
    const auto found =
        std::find_if(plan.rejected.begin(), plan.rejected.end(), [&](const Rejection& rejection) {
            return rejection.technique == technique;
        });
    return found == plan.rejected.end() ? "" : found->reason;
}

TEST(Picker, TakesTheCheapestInsideTheBudget) {
    const Plan plan = pick_one(box_over_floor(), {});

    ASSERT_EQ(plan.entries.size(), 1U);
    EXPECT_EQ(plan.entries[0].technique, "good");
}

TEST(Picker, EveryOtherTechniqueHasItsReason) {
    const Plan plan = pick_one(box_over_floor(), {});

    EXPECT_THAT(reason_for(plan, "exact"), HasSubstr("dearer"));
    EXPECT_THAT(reason_for(plan, "poor"), HasSubstr("over the budget of 1 px"));
    EXPECT_THAT(
        reason_for(plan, "planar"), HasSubstr("outside its domain: the receiver is not flat"));
    EXPECT_THAT(reason_for(plan, "truth"), HasSubstr("only for comparison"));
}

TEST(Picker, TakesTheLeastWrongWhenNothingIsGoodEnough) {
    Techniques techniques;
    techniques.push_back(std::make_unique<Fake>("bad", 9.0, 1.0));
    techniques.push_back(std::make_unique<Fake>("less_bad", 3.0, 1e6));

    const FramePlan plan = pick(box_over_floor(), {}, techniques, llvmpipe_profile());

    EXPECT_EQ(plan.plans.front().entries.front().technique, "less_bad");
    EXPECT_THAT(plan.plans.front().reason, HasSubstr("least error"));
}

TEST(Picker, HeroesHaveATighterBudget) {
    ShadowScene scene = box_over_floor();
    scene.casters[0].hero = true;

    EXPECT_EQ(pick_one(scene, {}).entries[0].technique, "exact");
}

TEST(Picker, APinHoldsAndSaysSo) {
    ShadowSettings settings;
    settings.lights["sun"].technique = "poor";

    const Plan plan = pick_one(box_over_floor(), settings);

    EXPECT_EQ(plan.entries[0].technique, "poor");
    EXPECT_EQ(plan.reason, "pinned");
    EXPECT_THAT(reason_for(plan, "good"), HasSubstr("not pinned"));
}

TEST(Picker, APinOutsideItsDomainServesNothingAndSaysWhy) {
    ShadowSettings settings;
    settings.scene.technique = "planar";

    const Plan plan = pick_one(box_over_floor(), settings);

    EXPECT_TRUE(plan.entries.empty());
    EXPECT_THAT(reason_for(plan, "planar"), HasSubstr("not flat"));
}

TEST(Picker, NeverKeepsATechniqueOut) {
    ShadowSettings settings;
    settings.receivers["floor"].never = std::vector<std::string>{"good"};

    EXPECT_EQ(pick_one(box_over_floor(), settings).entries[0].technique, "exact");
}

TEST(Picker, LaterRulesWin) {
    ShadowSettings settings;
    settings.scene.technique = "exact";
    scene::RuleDescription rule;
    rule.light = "sun";
    rule.receiver = "floor";
    rule.shadow.technique = "poor";
    settings.rules = {rule};

    EXPECT_EQ(pick_one(box_over_floor(), settings).entries[0].technique, "poor");
}

TEST(Picker, TheCommandLineWinsOverAll) {
    ShadowSettings settings;
    settings.lights["sun"].technique = "poor";
    settings.overriding[scene::LightKind::directional].technique = "exact";

    EXPECT_EQ(pick_one(box_over_floor(), settings).entries[0].technique, "exact");
}

TEST(Picker, ALightWithoutShadowsPlansNothing) {
    ShadowScene scene = box_over_floor();
    scene.lights[0].light.casts_shadow = false;

    EXPECT_TRUE(pick(scene, {}, some_techniques(), llvmpipe_profile()).plans.empty());
}

TEST(Picker, TiesGoToTheFirstName) {
    Techniques techniques;
    techniques.push_back(std::make_unique<Fake>("b", 0.5, 100.0));
    techniques.push_back(std::make_unique<Fake>("a", 0.5, 100.0));

    const FramePlan plan = pick(box_over_floor(), {}, techniques, llvmpipe_profile());

    EXPECT_EQ(plan.plans.front().entries.front().technique, "a");
}

TEST(PlanJson, NamesEverythingInWords) {
    const ShadowScene scene = box_over_floor();
    const FramePlan plan = pick(scene, {}, some_techniques(), llvmpipe_profile());

    const std::string json = plans_to_json(scene, plan);

    for (const char* word :
         {"\"light\": \"sun\"", "\"receiver\": \"floor\"", "\"technique\": \"good\"", "\"box\""})
        EXPECT_THAT(json, HasSubstr(word));
}

TEST(ShadowSettings, PatchesAndNodesFollowTheirModel) {
    ShadowSettings settings;
    settings.receivers["hero"].technique = "exact";

    EXPECT_EQ(settings.resolve(sun(), "hero/arm#2", 1.0).technique, "exact");
    EXPECT_FALSE(settings.resolve(sun(), "heroine", 1.0).technique.has_value());
}

TEST(ShadowSettings, ARuleWithADistanceBeginsThere) {
    ShadowSettings settings;
    scene::RuleDescription rule;
    rule.distance = 60.0F;
    rule.shadow.error_px = 4.0F;
    settings.rules = {rule};

    EXPECT_FALSE(settings.resolve(sun(), "floor", 59.0).error_px.has_value());
    EXPECT_EQ(settings.resolve(sun(), "floor", 60.0).error_px, 4.0F);
}

} // namespace
} // namespace shadows
