#include "systems/shadows/volumes/volume_tasks.hpp"

#include "systems/shadows/volumes/caster_proxy.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace shadows {

namespace {

using Receivers = std::unordered_map<std::uint32_t, const ReceiverView*>; // by id
using Tasks = std::map<std::pair<int, std::uint32_t>, VolumeTask>;        // by level and caster

Receivers receivers_of(const ShadowScene& scene) {
    Receivers receivers;
    for (const ReceiverView& receiver : scene.receivers)
        receivers[receiver.id] = &receiver;
    return receivers;
}

/// Adds what one entry of a plan asks for.
void add_entry(
    const ShadowRequest& request,
    const PlanEntry& entry,
    const ReceiverView& receiver,
    Tasks& tasks) {
    const LightView& light = request.scene.lights[request.light];
    const std::vector<std::uint8_t>& levels = entry.predicted.proxy_levels;
    std::size_t place = 0;
    for (const std::uint32_t group : entry.caster_groups)
        for (const std::uint32_t caster : request.groups[group].casters) {
            const int level = place < levels.size() ? levels[place] : 0;
            ++place;
            const auto reach =
                swept_reach(light, request.scene.casters[caster].bounds, receiver.bounds);
            if (!reach) continue;
            VolumeTask& task = tasks[{level, caster}];
            task.caster = caster;
            task.level = level;
            task.receivers.push_back(receiver.id);
            task.reaches.push_back(*reach);
        }
}

/// Gives tasks other levels, and makes one of those that are then of one caster and level.
template <class LevelOf>
Tasks merged(const Tasks& tasks, LevelOf level_of) {
    Tasks made;
    for (const auto& [key, task] : tasks) {
        const int level = level_of(task);
        VolumeTask& all = made[{level, task.caster}];
        all.caster = task.caster;
        all.level = level;
        all.receivers.insert(all.receivers.end(), task.receivers.begin(), task.receivers.end());
        all.reaches.insert(all.reaches.end(), task.reaches.begin(), task.reaches.end());
    }
    return made;
}

/// One volume per caster, its coarsest, for whatever it darkens.
Tasks with_coarsest_only(const Tasks& tasks) {
    std::map<std::uint32_t, int> coarsest;
    for (const auto& [key, task] : tasks)
        coarsest[task.caster] = std::max(coarsest[task.caster], task.level);
    return merged(tasks, [&](const VolumeTask& task) { return coarsest[task.caster]; });
}

/// No proxy of a caster that is drawn itself anyway.
Tasks without_needless_proxies(const Tasks& tasks) {
    return merged(tasks, [&](const VolumeTask& task) {
        return tasks.contains({0, task.caster}) ? 0 : task.level;
    });
}

bool may_serve_all(
    const ShadowScene& scene,
    const VolumeTask& task,
    const std::vector<std::uint32_t>& ids,
    const Receivers& receivers) {
    const CasterView& caster = scene.casters[task.caster];
    return std::all_of(ids.begin(), ids.end(), [&](std::uint32_t id) {
        return proxy_may_serve(caster, task.level, *receivers.at(id));
    });
}

bool fits(
    const ShadowScene& scene,
    const VolumeTask& task,
    const VolumePass& pass,
    const Receivers& receivers) {
    return may_serve_all(scene, task, pass.receivers, receivers)
           && std::all_of(pass.tasks.begin(), pass.tasks.end(), [&](const VolumeTask& other) {
                  return may_serve_all(scene, other, task.receivers, receivers);
              });
}

void join(VolumePass& pass, VolumeTask task) {
    pass.receivers.insert(pass.receivers.end(), task.receivers.begin(), task.receivers.end());
    std::sort(pass.receivers.begin(), pass.receivers.end());
    pass.receivers.erase(
        std::unique(pass.receivers.begin(), pass.receivers.end()), pass.receivers.end());
    pass.tasks.push_back(std::move(task));
}

} // namespace

std::vector<VolumePass> volume_passes(const ShadowRequest& request) {
    const Receivers receivers = receivers_of(request.scene);
    Tasks tasks;
    for (const Plan* plan : request.plans)
        for (const PlanEntry& entry : plan->entries)
            if (entry.technique == "volume")
                add_entry(request, entry, *receivers.at(plan->receiver), tasks);
    const bool apart = request.remedies.on(Remedy::volume_own_surface);
    if (!apart)
        tasks = with_coarsest_only(tasks);
    else if (!request.wish.proxy)
        tasks = without_needless_proxies(tasks);
    std::vector<VolumePass> passes(1);
    for (auto& [key, task] : tasks) {
        auto pass = passes.begin();
        if (apart && task.level > 0)
            pass = std::find_if(passes.begin() + 1, passes.end(), [&](const VolumePass& one) {
                return fits(request.scene, task, one, receivers);
            });
        if (pass == passes.end()) pass = passes.emplace(passes.end());
        join(*pass, std::move(task));
    }
    return passes;
}

} // namespace shadows
