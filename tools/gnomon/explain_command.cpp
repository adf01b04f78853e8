// gnomon explain: the plans of a scene and their reasons, as a table, in full for one pair, or as
// JSON. Needs no OpenGL.

#include "engine/core/text.hpp"
#include "engine/scene/receivers.hpp"
#include "engine/scene/views.hpp"
#include "systems/shadows/cost_model.hpp"
#include "systems/shadows/picker.hpp"
#include "systems/shadows/plan_json.hpp"
#include "systems/shadows/snapshot.hpp"
#include "systems/shadows/technique_registry.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "tools/gnomon/commands.hpp"
#include "tools/gnomon/failure.hpp"
#include "tools/gnomon/level.hpp"
#include "tools/gnomon/view_options.hpp"

namespace gnomon {

namespace {

struct Options {
    std::string scene;
    std::string pair; ///< "LIGHT,RECEIVER", or empty
    bool json = false;
    ViewOptions view;
    ShadowOptions shadow;
};

/// A frame's decisions with the names that people know.
struct Explained {
    shadows::ShadowScene scene;
    shadows::FramePlan plan;

    [[nodiscard]] std::string light_of(const shadows::Plan& pair) const {
        return scene.light(pair.light).name;
    }
    [[nodiscard]] std::string receiver_of(const shadows::Plan& pair) const {
        return scene.receiver(pair.receiver).name;
    }
    [[nodiscard]] std::string pair_of(const shadows::Plan& pair) const {
        return light_of(pair) + "," + receiver_of(pair);
    }
    /// Names of the casters that an entry serves, shortened after a few.
    [[nodiscard]] std::string
    casters_of(const shadows::Plan& pair, const shadows::PlanEntry& entry) const {
        constexpr std::size_t kShown = 4;
        std::vector<std::string> names;
        for (std::size_t light = 0; light < scene.lights.size(); ++light)
            if (scene.lights[light].id == pair.light)
                for (const std::uint32_t group : entry.caster_groups)
                    for (const std::uint32_t caster : plan.groups[light].groups[group].casters)
                        names.push_back(scene.casters[caster].name);
        const std::size_t all = names.size();
        names.resize(std::min(all, kShown));
        const std::string more = all > kShown ? fmt::format(" and {} more", all - kShown) : "";
        return fmt::format("{}{}", fmt::join(names, ", "), more);
    }
};

double cost_ms(const shadows::Prediction& predicted) {
    return shadows::milliseconds(predicted.cost, shadows::llvmpipe_profile());
}

std::string entry_text(const shadows::Plan& pair) {
    std::vector<std::string> names;
    for (const shadows::PlanEntry& entry : pair.entries)
        names.emplace_back(entry.technique);
    return names.empty() ? "(nothing)" : fmt::format("{}", fmt::join(names, " + "));
}

void print_table(const Explained& explained) {
    std::size_t width = 12;
    for (const shadows::Plan& pair : explained.plan.plans)
        width = std::max(width, explained.pair_of(pair).size());
    fmt::print(
        "{:<{}}  {:<16} {:>9} {:>9} {:>8}  {}\n",
        "light,receiver",
        width,
        "technique",
        "error px",
        "budget",
        "ms",
        "reason");
    for (const shadows::Plan& pair : explained.plan.plans) {
        double error_px = 0.0;
        double ms = 0.0;
        for (const shadows::PlanEntry& entry : pair.entries) {
            error_px = std::max(error_px, entry.predicted.error_px);
            ms += cost_ms(entry.predicted);
        }
        fmt::print(
            "{:<{}}  {:<16} {:>9.3f} {:>9.3g} {:>8.3f}  {}\n",
            explained.pair_of(pair),
            width,
            entry_text(pair),
            error_px,
            pair.budget_px,
            ms,
            pair.reason);
    }
}

void print_pair(const Explained& explained, const shadows::Plan& pair) {
    fmt::print("{}\nbudget {:.3g} px\n", explained.pair_of(pair), pair.budget_px);
    for (const shadows::PlanEntry& entry : pair.entries)
        fmt::print(
            "  {:<16} {:.3f} px, {:.0f} error px, {:.3f} ms: {}\n    casters: {}\n",
            entry.technique,
            entry.predicted.error_px,
            entry.predicted.error_area_px,
            cost_ms(entry.predicted),
            pair.reason,
            explained.casters_of(pair, entry));
    if (pair.entries.empty()) fmt::print("  nothing: {}\n", pair.reason);
    fmt::print("not taken\n");
    for (const shadows::Rejection& rejection : pair.rejected)
        fmt::print("  {:<16} {}\n", rejection.technique, rejection.reason);
}

Explained explain(
    const Level& level, const scene::CameraView& camera, const shadows::Techniques& techniques) {
    Explained explained;
    explained.scene = shadows::take_snapshot(
        level.world, scene::ReceiverTable(level.world), camera, scene::placed_lights(level.world));
    explained.plan =
        shadows::pick(explained.scene, level.shadows, techniques, shadows::llvmpipe_profile());
    return explained;
}

int print_one(const Explained& explained, const std::string& wanted) {
    std::vector<std::string> names;
    for (const shadows::Plan& pair : explained.plan.plans) {
        names.push_back(explained.pair_of(pair));
        if (names.back() != wanted) continue;
        print_pair(explained, pair);
        return kFine;
    }
    const std::vector<std::string_view> words(names.begin(), names.end());
    return fail(
        {fmt::format(
            "--pair {}: no such pair of light and receiver needs a decision from this camera{}",
            wanted,
            engine::did_you_mean(wanted, words))},
        kWrongUsage);
}

int run(const Options& options) {
    const auto size = options.view.size_px();
    if (!size) return fail(size.error(), kWrongUsage);
    auto level = load_level(options.scene);
    if (!level) return fail(level.error(), kBadFile);
    const auto camera = choose_camera(*level, options.view.camera, size->x, size->y);
    if (!camera) return fail(camera.error(), kWrongUsage);
    const auto techniques = shadows::all_techniques();
    const auto asked = options_from_word(options.shadow.technique, techniques, options.shadow);
    if (!asked) return fail(asked.error(), kWrongUsage);
    override_wishes(level->shadows, *asked);
    const Explained explained = explain(*level, *camera, techniques);
    if (options.json)
        fmt::print("{}\n", shadows::plans_to_json(explained.scene, explained.plan));
    else if (!options.pair.empty())
        return print_one(explained, options.pair);
    else
        print_table(explained);
    return kFine;
}

} // namespace

Run add_explain(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "explain", "the plan of every pair of light and receiver, and its reasons");
    command->add_option("scene", options->scene, "SCENE.lua, .glb or .gltf")->required();
    command->add_option("--pair", options->pair, "LIGHT,RECEIVER: everything about one pair");
    command->add_flag("--json", options->json, "as plans.json holds them");
    add_view_options(*command, options->view);
    add_shadow_options(*command, options->shadow);
    return [options] { return run(*options); };
}

} // namespace gnomon
