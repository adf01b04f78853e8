#include "systems/shadows/shadow_system.hpp"

#include "systems/shadows/picker.hpp"
#include "systems/shadows/snapshot.hpp"

#include <embedded/shadows_shaders.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace shadows {

namespace {

/// Changes whenever something moves, deforms, comes, goes or gets another name.
std::uint64_t versions_of(const scene::World& world) {
    const auto& registry = world.registry;
    return registry.version<scene::MeshInstance>() + registry.version<scene::WorldTransform>()
           + registry.version<scene::ShadowRole>() + registry.version<scene::PosedMesh>()
           + registry.version<scene::Name>();
}

/// Everything about a light that a job draws from.
std::string light_text(const LightView& light) {
    const scene::Light& l = light.light;
    return fmt::format(
        "{} {} {} {} {} {} {} {} {} {} {} {}",
        static_cast<int>(l.kind),
        light.position.x,
        light.position.y,
        light.position.z,
        light.direction.x,
        light.direction.y,
        light.direction.z,
        l.range,
        l.inner_angle,
        l.outer_angle,
        l.radius,
        l.angular_radius);
}

/// What was asked and planned. Numbers of plans as bytes: there are thousands.
std::string plans_text(const std::vector<const Plan*>& plans, const scene::ShadowWish& wish) {
    std::string text = fmt::format(
        "{} {} {} {} {}",
        wish.map_size.value_or(0),
        wish.filter.value_or(""),
        wish.samples.value_or(0),
        wish.cascades.value_or(0),
        wish.error_px.value_or(0.0F));
    const auto put = [&](std::uint32_t number) {
        text.append(reinterpret_cast<const char*>(&number), sizeof(number));
    };
    for (const Plan* plan : plans) {
        put(plan->receiver);
        put(static_cast<std::uint32_t>(plan->entries.size()));
        for (const PlanEntry& entry : plan->entries) {
            text += entry.technique;
            put(static_cast<std::uint32_t>(entry.caster_groups.size()));
            for (const std::uint32_t group : entry.caster_groups)
                put(group);
            text.append(entry.predicted.proxy_levels.begin(), entry.predicted.proxy_levels.end());
            for (const Variant& variant : entry.variants) {
                text += variant.way;
                put(variant.samples);
            }
        }
    }
    return text;
}

} // namespace

std::vector<gpu::ShaderFolder> shader_folders() {
    return {embedded::shadows_shaders()};
}

ShadowSystem::ShadowSystem(DeviceProfile profile)
    : techniques_(all_techniques()),
      profile_(profile) {}

engine::Result<void> ShadowSystem::prepare(const render::FrameInput& input) {
    PlannedFrom from{
        input.world.identity.number(),
        versions_of(input.world),
        input.camera,
        {input.lights.begin(), input.lights.end()},
        settings,
        remedies,
        wraps_stencil};
    const bool world_changed = from.versions != planned_from_.versions;
    if (from.world != planned_from_.world || from.remedies != planned_from_.remedies) jobs_.clear();
    if (from != planned_from_) make_plan(input);
    planned_from_ = std::move(from);
    return update_due_jobs(input, world_changed);
}

void ShadowSystem::make_plan(const render::FrameInput& input) {
    scene_ = take_snapshot(input.world, input.receivers, input.camera, input.lights);
    scene_.wraps_stencil = wraps_stencil;
    plan_ = pick(scene_, settings, techniques_, profile_);
    assign_jobs();
}

void ShadowSystem::assign_jobs() {
    for (auto& [key, running] : jobs_)
        running.plans.clear();
    for (const Plan& plan : plan_.plans) {
        for (const PlanEntry& entry : plan.entries) {
            const JobKey key{plan.light, entry.technique};
            auto found = jobs_.find(key);
            if (found == jobs_.end()) {
                auto job = find_technique(techniques_, entry.technique)->start();
                if (job == nullptr) continue;
                found = jobs_.emplace(key, RunningJob{std::move(job)}).first;
            }
            found->second.plans.push_back(&plan);
        }
    }
    std::erase_if(jobs_, [](const auto& entry) { return entry.second.plans.empty(); });
    for (auto& [key, running] : jobs_) {
        running.light = scene_.index_of_light(key.first);
        const LightView& light = scene_.lights[running.light];
        running.wish = settings.resolve(light, "", 0.0);
        running.wanted = {light_text(light), plans_text(running.plans, running.wish)};
    }
}

engine::Result<void>
ShadowSystem::update_due_jobs(const render::FrameInput& input, bool world_changed) {
    due_.clear();
    const std::function<const trace::TraceScene&()> ask_truth = [&]() -> const trace::TraceScene& {
        return truth(input.world);
    };
    const auto receiver_end = input.receivers.end();
    for (auto& [key, running] : jobs_) {
        const auto& groups = plan_.groups[running.light].groups;
        const ShadowRequest request{
            input.world,
            scene_,
            running.light,
            groups,
            running.plans,
            receiver_end,
            serves_all(key),
            running.wish,
            remedies,
            ask_truth};
        running.outdated = running.outdated || world_changed;
        ++running.age;
        if (!always_refresh && !is_due(running, request)) continue;
        if (auto updated = running.job->update(request); !updated) return updated;
        running.drawn_for = running.wanted;
        running.age = 0;
        running.outdated = false;
        due_.push_back(&running);
    }
    return {};
}

bool ShadowSystem::is_due(const RunningJob& running, const ShadowRequest& request) const {
    const bool waits = running.job->may_wait() && running.age < running.wish.refresh.value_or(1)
                       && running.wanted.plans == running.drawn_for.plans;
    if (waits) return false;
    return running.outdated || running.wanted != running.drawn_for
           || !running.job->still_serves(request);
}

bool ShadowSystem::serves_all(const JobKey& key) const {
    return scene_.everything_receives
           && std::all_of(plan_.plans.begin(), plan_.plans.end(), [&](const Plan& plan) {
                  return plan.light != key.first
                         || (plan.entries.size() == 1
                             && plan.entries.front().technique == key.second);
              });
}

const trace::TraceScene& ShadowSystem::truth(const scene::World& world) {
    truth_.update(world);
    return truth_;
}

bool ShadowSystem::serves(std::size_t light) const {
    return std::any_of(
        jobs_.begin(), jobs_.end(), [&](const auto& entry) { return entry.second.light == light; });
}

bool ShadowSystem::needs_stencil() const {
    return std::any_of(jobs_.begin(), jobs_.end(), [](const auto& entry) {
        return entry.second.job->needs_stencil();
    });
}

engine::Result<void> ShadowSystem::refresh(
    gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) {
    for (RunningJob* running : due_)
        if (auto rendered = running->job->render(frame, shaders, geometry); !rendered)
            return rendered;
    return {};
}

void ShadowSystem::apply(
    gpu::Frame& frame, std::size_t light, const render::VisibilityTarget& target) {
    for (auto& [key, running] : jobs_)
        if (running.light == light) running.job->apply(frame, scene_.camera, target);
}

const ShadowJob* ShadowSystem::job(std::uint32_t light, std::string_view technique) const {
    const auto found = jobs_.find(JobKey{light, technique});
    return found == jobs_.end() ? nullptr : found->second.job.get();
}

std::vector<std::string> ShadowSystem::unserved() const {
    std::vector<std::string> sentences;
    for (const Plan& plan : plan_.plans) {
        if (!plan.entries.empty()) continue;
        std::string reasons;
        for (const Rejection& rejection : plan.rejected)
            reasons += fmt::format(
                "{}{}: {}", reasons.empty() ? "" : "; ", rejection.technique, rejection.reason);
        sentences.push_back(fmt::format("light '{}': {}", scene_.light(plan.light).name, reasons));
    }
    std::sort(sentences.begin(), sentences.end());
    sentences.erase(std::unique(sentences.begin(), sentences.end()), sentences.end());
    return sentences;
}

std::vector<int> ShadowSystem::ages(std::size_t light) const {
    std::vector<int> ages;
    for (const auto& [key, running] : jobs_)
        if (running.light == light) {
            const bool stale = running.outdated || running.wanted != running.drawn_for;
            ages.push_back(stale ? running.age : 0);
        }
    return ages;
}

std::size_t ShadowSystem::gpu_bytes() const {
    std::size_t sum = 0;
    for (const auto& [key, running] : jobs_)
        sum += running.job->gpu_bytes();
    return sum;
}

} // namespace shadows
