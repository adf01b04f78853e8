// gnomon check: reads a scene or a model and reports what is in it, what is wrong with it, and what
// the picker would do. Needs no OpenGL.

#include "engine/scene/receivers.hpp"
#include "engine/scene/views.hpp"
#include "systems/shadows/picker.hpp"
#include "systems/shadows/snapshot.hpp"
#include "systems/shadows/technique_registry.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>
#include <memory>

#include "tools/gnomon/commands.hpp"
#include "tools/gnomon/failure.hpp"
#include "tools/gnomon/level.hpp"

namespace gnomon {

namespace {

/// Plans are made for this picture, since errors are counted in its pixels.
constexpr int kWidth = 1280;
constexpr int kHeight = 720;

void print_meshes(const scene::Assets& assets) {
    fmt::print(
        "{:<28} {:>9} {:>8} {:>8} {:>9} {:>8} {:>9} {:>7}  health\n",
        "mesh",
        "triangles",
        "by index",
        "open",
        "non-manif",
        "flipped",
        "zero-area",
        "patches");
    for (const scene::Mesh& mesh : assets.meshes) {
        const scene::MeshHealth& health = mesh.health;
        fmt::print(
            "{:<28} {:>9} {:>8} {:>8} {:>9} {:>8} {:>9} {:>7}  {}{}\n",
            mesh.name,
            health.triangles,
            health.open_edges_by_index,
            health.open_edges,
            health.non_manifold_edges,
            health.flipped_edges,
            health.degenerate_triangles,
            mesh.patches.size(),
            health.summary(),
            mesh.deforms() ? ", deforms" : "");
    }
}

/// How many pairs each technique would serve.
void print_plans(const Level& level, const shadows::FramePlan& plan) {
    std::map<std::string_view, std::size_t> counts;
    for (const shadows::Plan& pair : plan.plans)
        for (const shadows::PlanEntry& entry : pair.entries)
            ++counts[entry.technique];
    fmt::print(
        "auto at {}x{}: {} pairs of light and receiver\n", kWidth, kHeight, plan.plans.size());
    for (const auto& [technique, count] : counts)
        fmt::print("  {:<16} {} pairs\n", technique, count);
    if (scene::placed_lights(level.world).empty()) fmt::print("  no light is on\n");
}

int check_one(const std::string& file) {
    const auto level = load_level(file);
    if (!level) return fail(level.error(), kBadFile);
    const auto camera = choose_camera(*level, "", kWidth, kHeight);
    if (!camera) return fail(camera.error(), kBadFile);
    const auto lights = scene::placed_lights(level->world);
    const auto bounds = scene::world_bounds(level->world);
    const scene::ReceiverTable receivers(level->world);
    fmt::print("{}\n", file);
    fmt::print(
        "{} meshes in {} entities, {} lights, {} cameras\n",
        level->world.assets.meshes.size(),
        receivers.ranges().size(),
        lights.size(),
        scene::camera_names(level->world).size());
    if (!bounds.empty()) {
        const glm::dvec3 extent = bounds.extent();
        fmt::print("{:.3g} x {:.3g} x {:.3g} m\n", extent.x, extent.y, extent.z);
    }
    print_meshes(level->world.assets);
    const auto techniques = shadows::all_techniques();
    const auto snapshot = shadows::take_snapshot(level->world, receivers, *camera, lights);
    print_plans(
        *level, shadows::pick(snapshot, level->shadows, techniques, shadows::llvmpipe_profile()));
    for (const std::string& warning : level->warnings)
        fmt::print("warning: {}\n", warning);
    fmt::print("\n");
    return kFine;
}

} // namespace

Run add_check(CLI::App& app) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command =
        app.add_subcommand("check", "reads scenes or models and reports what is in them");
    command->add_option("scene", *files, "SCENE.lua, .glb or .gltf")->required();
    return [files] {
        int worst = kFine;
        for (const std::string& file : *files)
            worst = std::max(worst, check_one(file));
        return worst;
    };
}

} // namespace gnomon
