// The shadow system: takes a snapshot, plans every pair, keeps the jobs that plans name, and lowers
// masks. The one class that knows both sides of the wall.

#pragma once

#include "engine/render/light_visibility.hpp"
#include "engine/trace/trace_scene.hpp"
#include "systems/shadows/cost_model.hpp"
#include "systems/shadows/shadow_settings.hpp"
#include "systems/shadows/technique_registry.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace shadows {

/// Shaders of the techniques, for the renderer's library.
std::vector<gpu::ShaderFolder> shader_folders();

class ShadowSystem final : public render::LightVisibility {
public:
    explicit ShadowSystem(DeviceProfile profile = llvmpipe_profile());

    ShadowSettings settings;
    /// For tests of what each is there for.
    Remedies remedies;
    /// Whether this driver counts as stencil volumes need it; they are refused where it does not.
    bool wraps_stencil = true;
    /// Every job is redrawn in every frame, so that no cache flatters a timing.
    bool always_refresh = false;

    engine::Result<void> prepare(const render::FrameInput& input) override;
    [[nodiscard]] bool serves(std::size_t light) const override;
    [[nodiscard]] bool needs_stencil() const override;
    engine::Result<void> refresh(
        gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) override;
    void
    apply(gpu::Frame& frame, std::size_t light, const render::VisibilityTarget& target) override;

    /// Of the last prepared frame.
    [[nodiscard]] const ShadowScene& scene() const { return scene_; }
    [[nodiscard]] const FramePlan& plan() const { return plan_; }
    [[nodiscard]] const Techniques& techniques() const { return techniques_; }
    /// What draws the masks of the plans that name a technique for a light. Null when nothing has
    /// to be drawn. @param light its id
    [[nodiscard]] const ShadowJob* job(std::uint32_t light, std::string_view technique) const;
    /// Pairs that got no technique although something can darken them, as sentences.
    [[nodiscard]] std::vector<std::string> unserved() const;
    /// Jobs redrawn in the last frame.
    [[nodiscard]] std::size_t refresh_count() const { return due_.size(); }
    /// By how many frames each job of a light stands behind: those since it was last redrawn, 0
    /// when nothing has moved since. @param light an index into scene().lights
    [[nodiscard]] std::vector<int> ages(std::size_t light) const;
    [[nodiscard]] std::size_t gpu_bytes() const;

private:
    /// A light's id and the technique at work for it.
    using JobKey = std::pair<std::uint32_t, std::string_view>;

    /// All that plans are made from: equal values, equal plans.
    struct PlannedFrom {
        std::uint64_t world = 0;    ///< its number; 0: there is no plan
        std::uint64_t versions = 0; ///< of what a snapshot copies from it
        scene::CameraView camera;
        std::vector<scene::PlacedLight> lights;
        ShadowSettings settings;
        Remedies remedies;
        bool wraps_stencil = true;

        bool operator==(const PlannedFrom&) const = default;
    };

    /// What a job draws, as text: equal text, equal work.
    struct Work {
        std::string light; ///< where it is and how it shines
        std::string plans; ///< what is served how, with the numbers of plans as bytes

        bool operator==(const Work&) const = default;
    };

    /// A job with what it was last drawn for.
    struct RunningJob {
        std::unique_ptr<ShadowJob> job;
        std::uint32_t light = 0;             ///< index into scene_.lights
        std::vector<const Plan*> plans = {}; ///< into plan_
        scene::ShadowWish wish = {};         ///< for its light as a whole
        Work wanted = {};
        Work drawn_for = {};   ///< at the last refresh; empty: never
        int age = 0;           ///< frames since then
        bool outdated = false; ///< something has moved since then
    };

    void make_plan(const render::FrameInput& input);
    void assign_jobs();
    engine::Result<void> update_due_jobs(const render::FrameInput& input, bool world_changed);
    [[nodiscard]] bool is_due(const RunningJob& running, const ShadowRequest& request) const;
    [[nodiscard]] bool serves_all(const JobKey& key) const;
    const trace::TraceScene& truth(const scene::World& world);

    Techniques techniques_;
    DeviceProfile profile_;
    ShadowScene scene_;
    FramePlan plan_;
    std::map<JobKey, RunningJob> jobs_;
    std::vector<RunningJob*> due_;
    PlannedFrom planned_from_;
    trace::TraceScene truth_;
};

} // namespace shadows
