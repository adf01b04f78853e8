#include "systems/shadows/picker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace shadows {

namespace {

/// A technique that could serve a pair.
struct Option {
    const ShadowTechnique* technique;
    Prediction predicted;
    double cost_ms;
    std::vector<Variant> variants; ///< by group of the pair
};

/// Comparisons see numbers in steps of 1/1024, so that the last bits of a processor never decide.
double rounded(double value) {
    return std::round(value * 1024.0) / 1024.0;
}

/// What a technique would do for all the pair's groups together. Displacements do not add up: the
/// worst one counts.
engine::Result<Option> predict_all(
    const ShadowTechnique& technique,
    const PairView& view,
    const Pair& pair,
    const FramePlan::LightGroups& light,
    const DeviceProfile& profile) {
    Option option{&technique, {}, 0.0, {}};
    Prediction& sum = option.predicted;
    std::size_t casters_before = 0;
    for (const std::uint32_t group : pair.groups) {
        const auto part = technique.predict(view, light.groups[group]);
        if (!part) return part.error();
        sum.error_px = std::max(sum.error_px, part->error_px);
        sum.error_area_px += part->error_area_px;
        sum.cost += part->cost;
        if (!part->proxy_levels.empty()) {
            sum.proxy_levels.resize(casters_before);
            sum.proxy_levels.insert(
                sum.proxy_levels.end(), part->proxy_levels.begin(), part->proxy_levels.end());
        }
        casters_before += light.groups[group].casters.size();
        if (!part->note.empty()) sum.note += (sum.note.empty() ? "" : "; ") + part->note;
        sum.variant.samples = std::max(sum.variant.samples, part->variant.samples);
        option.variants.push_back(part->variant);
    }
    option.cost_ms = milliseconds(sum.cost, profile);
    return option;
}

double
budget_of(const scene::ShadowWish& wish, const Pair& pair, const FramePlan::LightGroups& light) {
    if (wish.error_px) return static_cast<double>(*wish.error_px);
    const bool hero = std::any_of(pair.groups.begin(), pair.groups.end(), [&](std::uint32_t group) {
        return light.groups[group].hero;
    });
    return hero ? kHeroBudgetPx : kDefaultBudgetPx;
}

/// The designer's say (never, pins); no value when it may be taken.
std::optional<std::string_view>
forbidden(const TechniqueTraits& traits, const scene::ShadowWish& wish) {
    const std::string_view pinned = wish.technique ? std::string_view(*wish.technique) : "auto";
    if (pinned != "auto" && pinned != traits.name) return "not pinned";
    if (pinned == "auto" && !traits.picked_by_auto) return "only for comparison";
    if (wish.never
        && std::find(wish.never->begin(), wish.never->end(), traits.name) != wish.never->end())
        return "named in 'never'";
    return std::nullopt;
}

/// The cheapest inside the budget, else the least wrong; ties go to the first name.
const Option* choose(const std::vector<Option>& options, double budget_px) {
    const auto better = [&](const Option& a, const Option& b) {
        const bool a_holds = rounded(a.predicted.error_px) <= budget_px;
        const bool b_holds = rounded(b.predicted.error_px) <= budget_px;
        if (a_holds != b_holds) return a_holds;
        const double a_first = rounded(a_holds ? a.cost_ms : a.predicted.error_px);
        const double b_first = rounded(b_holds ? b.cost_ms : b.predicted.error_px);
        if (a_first != b_first) return a_first < b_first;
        return a.technique->traits().name < b.technique->traits().name;
    };
    const auto best = std::min_element(options.begin(), options.end(), better);
    return best == options.end() ? nullptr : &*best;
}

std::string why_not(const Option& option, const Option& chosen, double budget_px) {
    if (rounded(option.predicted.error_px) > budget_px)
        return fmt::format(
            "error {:.3g} px over the budget of {:.3g} px", option.predicted.error_px, budget_px);
    return fmt::format("{:.3g} ms, dearer than {:.3g} ms", option.cost_ms, chosen.cost_ms);
}

std::string why(const Option& chosen, const scene::ShadowWish& wish, double budget_px) {
    if (wish.technique.value_or("auto") != "auto") return "pinned";
    if (rounded(chosen.predicted.error_px) <= budget_px)
        return fmt::format("cheapest within {:.3g} px", budget_px);
    return fmt::format("none within {:.3g} px; least error", budget_px);
}

Plan pick_pair(
    const PairView& view,
    const Pair& pair,
    const FramePlan::LightGroups& light,
    const Techniques& techniques,
    const DeviceProfile& profile) {
    const scene::ShadowWish& wish = view.wish;
    Plan plan;
    plan.light = view.light.id;
    plan.receiver = view.receiver.id;
    plan.budget_px = view.budget_px;
    std::vector<Option> options;
    plan.rejected.reserve(techniques.size());
    for (const auto& technique : techniques) {
        const TechniqueTraits& traits = technique->traits();
        if (const auto reason = forbidden(traits, wish)) {
            plan.rejected.push_back({traits.name, std::string(*reason), std::nullopt});
            continue;
        }
        auto option = predict_all(*technique, view, pair, light, profile);
        if (!option)
            plan.rejected.push_back(
                {traits.name, "outside its domain: " + option.error().message, std::nullopt});
        else
            options.push_back(*std::move(option));
    }
    const Option* chosen = choose(options, plan.budget_px);
    if (chosen == nullptr) {
        plan.reason = "no technique may serve this pair";
        return plan;
    }
    plan.reason = why(*chosen, wish, plan.budget_px);
    if (!chosen->predicted.note.empty()) plan.reason += "; " + chosen->predicted.note;
    plan.entries.push_back(
        {chosen->technique->traits().name, pair.groups, chosen->predicted, chosen->variants});
    for (const Option& option : options)
        if (&option != chosen)
            plan.rejected.push_back(
                {option.technique->traits().name,
                 why_not(option, *chosen, plan.budget_px),
                 option.predicted});
    return plan;
}

} // namespace

FramePlan pick(
    const ShadowScene& scene,
    const ShadowSettings& settings,
    const Techniques& techniques,
    const DeviceProfile& profile) {
    FramePlan frame;
    for (std::uint32_t index = 0; index < scene.lights.size(); ++index) {
        const LightView& light = scene.lights[index];
        frame.groups.push_back({light.id, {}});
        if (!light.light.casts_shadow) continue;
        frame.groups.back().groups = group_casters(scene, light);
        for (const Pair& pair : find_pairs(scene, index, frame.groups.back().groups)) {
            const ReceiverView& receiver = scene.receivers[pair.receiver];
            const glm::dvec3 nearest =
                glm::clamp(scene.camera.position, receiver.bounds.min, receiver.bounds.max);
            const double distance = glm::length(nearest - scene.camera.position);
            const scene::ShadowWish wish = settings.resolve(light, receiver.name, distance);
            const double budget_px = budget_of(wish, pair, frame.groups.back());
            frame.plans.push_back(pick_pair(
                {scene, light, receiver, wish, budget_px},
                pair,
                frame.groups.back(),
                techniques,
                profile));
        }
    }
    return frame;
}

} // namespace shadows
