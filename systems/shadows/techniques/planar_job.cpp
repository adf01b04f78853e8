#include "systems/shadows/techniques/planar_job.hpp"

#include "engine/gpu/pass.hpp"
#include "engine/render/light_visibility.hpp"
#include "systems/shadows/planar_prediction.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/kept_shadows.hpp"
#include "systems/shadows/techniques/planar_draws.hpp"
#include "systems/shadows/techniques/planar_sum.hpp"
#include "systems/shadows/techniques/plateau_draws.hpp"
#include "systems/shadows/techniques/rectangles.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace shadows {

namespace {

/// Marks that tell receivers apart until the stencil is wiped.
constexpr std::uint8_t kLastMark = 127;

/// What one receiver needs of its casters, and where they are in the job's draws.
struct Serving {
    PlanarCasters casters;
    PlanarDraws::Runs runs = {};
    std::optional<PlateauDraws::Range> skirt = {}; ///< of a plateau
    KeptShadow* kept = nullptr;
    bool always_kept = false;
    double budget_px = 1.0;

    /// Summed up apart before it comes into the mask.
    [[nodiscard]] bool soft() const { return skirt || casters.samples.size() != 1; }
    [[nodiscard]] bool looked_up() const {
        return kept != nullptr && (always_kept || kept->still());
    }
};

bool goes(const PlanEntry& entry, std::string_view way) {
    return std::any_of(entry.variants.begin(), entry.variants.end(), [&](const Variant& variant) {
        return variant.way == way;
    });
}

/// Where one plane for all receivers that face the same way would lie.
double lowest_plane(const ShadowRequest& request, const ReceiverView& receiver) {
    double lowest = receiver.offset;
    for (const Plan* plan : request.plans) {
        const ReceiverView& other = request.scene.receiver(plan->receiver);
        if (other.flat && glm::dot(other.normal, receiver.normal) > 0.999)
            lowest = std::min(lowest, other.offset);
    }
    return lowest;
}

/// Texels of a kept shadow.
glm::ivec2
wanted_size(const scene::CameraView& camera, const PlanarCasters& casters, double budget_px) {
    const double texel_m = kKeptTexelPerBudget * budget_px * pixel_size_at(camera, casters.bounds);
    return kept_size(plane_rectangle(casters.plane, casters.bounds), texel_m);
}

class PlanarJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_ = request.scene.lights[request.light];
        remedies_ = request.remedies;
        origin_ = request.scene.camera.position;
        size_ = {request.scene.camera.width, request.scene.camera.height};
        servings_.clear();
        skirts_.begin();
        for (const Plan* plan : request.plans)
            serve(request, *plan);
        std::erase_if(kept_, [&](const auto& kept) {
            return std::none_of(servings_.begin(), servings_.end(), [&](const Serving& serving) {
                return serving.kept == &kept.second;
            });
        });
        return {};
    }

    [[nodiscard]] bool still_serves(const ShadowRequest& request) const override {
        const scene::CameraView& camera = request.scene.camera;
        return size_ == glm::ivec2(camera.width, camera.height)
               && std::all_of(servings_.begin(), servings_.end(), [&](const Serving& serving) {
                      return serving.kept == nullptr
                             || serving.kept->fits(
                                 wanted_size(camera, serving.casters, serving.budget_px));
                  });
    }

    engine::Result<void> render(
        gpu::Frame& /*frame*/,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry) override {
        if (auto fetched = fetch_programs(shaders); !fetched) return fetched;
        if (auto fetched = draws_.fetch_programs(shaders, remedies_); !fetched) return fetched;
        if (auto uploaded = skirts_.upload(shaders); !uploaded) return uploaded;
        draws_.begin(geometry, light_, origin_);
        for (Serving& serving : servings_)
            serving.runs = draws_.append(serving.casters, geometry);
        draws_.upload(geometry);
        return prepare_targets();
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        std::vector<Shown> hard;
        std::vector<Shown> soft;
        std::vector<Shown> kept;
        for (const Serving& serving : servings_) {
            if (serving.casters.plane.height(camera.position) <= 0.0) continue;
            const gpu::Rect area =
                intersection(to_rect(screen_bounds(camera, serving.casters.bounds)), target.area);
            if (area.empty()) continue;
            (serving.looked_up() ? kept : serving.soft() ? soft : hard).push_back({&serving, area});
            if (serving.kept != nullptr) serving.kept->pass_frame();
        }
        if (!hard.empty()) darken(frame, camera, target, hard);
        if (!soft.empty()) dim(frame, camera, target, soft);
        if (!kept.empty()) look_up(frame, camera, target, kept);
    }

    [[nodiscard]] bool needs_stencil() const override { return true; }

    [[nodiscard]] Resolution
    resolution(const scene::CameraView& camera, const SurfacePoint& point) const override {
        Resolution coarsest;
        const double pixel = glm::length(point.position - camera.position) * camera.pixel_size();
        for (const Serving& serving : servings_) {
            if (!serving.looked_up()) continue;
            const LitPlane& plane = serving.casters.plane;
            const bool on_plane = std::abs(plane.height(point.position)) < pixel;
            if (on_plane && glm::dot(plane.normal, point.normal) > 0.99)
                coarsest = coarser(coarsest, {serving.kept->texture().texel_m() / pixel, 0.0});
        }
        return coarsest;
    }

    [[nodiscard]] std::size_t gpu_bytes() const override {
        std::size_t sum = draws_.gpu_bytes() + sum_.gpu_bytes() + skirts_.gpu_bytes();
        for (const auto& [receiver, kept] : kept_)
            sum += kept.texture().gpu_bytes();
        return sum;
    }

private:
    /// A receiver whose shadow the camera may see.
    struct Shown {
        const Serving* serving;
        gpu::Rect area;
    };

    void serve(const ShadowRequest& request, const Plan& plan) {
        ReceiverView receiver = request.scene.receiver(plan.receiver);
        if (!remedies_.on(Remedy::planar_own_plane))
            receiver.offset = lowest_plane(request, receiver);
        for (const PlanEntry& entry : plan.entries) {
            if (entry.technique != "planar") continue;
            auto casters = planar_casters(
                request.scene, light_, receiver, request.groups, entry, origin_, remedies_);
            if (!casters) continue;
            servings_.push_back({*std::move(casters)});
            Serving& serving = servings_.back();
            serving.budget_px = plan.budget_px;
            serving.always_kept = goes(entry, planar_way::kTexture);
            if (draws_plateau(entry, remedies_))
                serving.skirt = skirts_.append(request, serving.casters, origin_);
            else
                keep(request, entry, serving);
        }
    }

    /// Still shadows of large lights are looked up where that is cheaper.
    void keep(const ShadowRequest& request, const PlanEntry& entry, Serving& serving) {
        const scene::CameraView& camera = request.scene.camera;
        const PlanarCasters& casters = serving.casters;
        const bool pays =
            serving.soft()
            && keeping_pays(entry.predicted.cost, screen_bounds(camera, casters.bounds).area());
        if (!serving.always_kept && !pays) return;
        serving.kept = &kept_[casters.receiver];
        serving.kept->follow(
            kept_from(request, entry, casters),
            wanted_size(camera, casters, serving.budget_px),
            remedies_);
    }

    engine::Result<void> fetch_programs(gpu::ShaderLibrary& shaders) {
        const auto mark = shaders.graphics("gpu/fullscreen.vert", "shadows/planar_mark.frag");
        if (!mark) return mark.error();
        const auto sum = shaders.graphics("gpu/fullscreen.vert", "shadows/planar_sum.frag");
        if (!sum) return sum.error();
        const auto kept = shaders.graphics("shadows/screen_ray.vert", "shadows/plane_texture.frag");
        if (!kept) return kept.error();
        mark_ = *mark;
        sum_mask_ = *sum;
        kept_mask_ = *kept;
        return {};
    }

    engine::Result<void> prepare_targets() {
        bool soft = false;
        for (const Serving& serving : servings_) {
            soft = soft || serving.soft();
            if (serving.kept == nullptr) continue;
            const auto label = fmt::format("planar/{}/{}", light_.name, serving.casters.receiver);
            if (auto prepared = serving.kept->prepare(label); !prepared) return prepared;
        }
        if (!soft) return {};
        return sum_.prepare(fmt::format("planar/{}/sum", light_.name), size_, remedies_);
    }

    [[nodiscard]] bool tagged() const {
        return remedies_.on(Remedy::planar_stencil) && remedies_.on(Remedy::planar_no_offset);
    }

    /// Hard shadows, straight into the mask.
    void darken(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target,
        const std::vector<Shown>& hard) {
        const gpu::ScopedPass pass(
            frame, fmt::format("planar/{}", light_.name), *target.mask_with_stencil);
        const glm::dmat4 clip = clip_from_origin(camera, origin_);
        gpu::Rect marked;
        std::uint8_t mark = 0;
        for (const auto& [serving, area] : hard) {
            if (mark == kLastMark) {
                wipe(frame, *target.mask_with_stencil, marked);
                mark = 0;
            }
            ++mark;
            marked = hull(marked, area);
            if (tagged()) mark_receiver(frame, target, *serving, area, mark);
            const gpu::Rect& drawn = tagged() ? area : target.area;
            draws_.draw(
                frame,
                {clip, serving->casters.samples.front(), 0.0F},
                serving->runs,
                shading_state(drawn, mark));
            frame.counters().mask_fragments += pixels(drawn);
        }
        wipe(frame, *target.mask_with_stencil, marked);
    }

    /// Soft shadows, summed up apart and then brought into the mask.
    void
    dim(gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target,
        const std::vector<Shown>& soft) {
        gpu::Rect round;
        for (const Shown& shown : soft)
            round = hull(round, shown.area);
        const glm::dmat4 clip = clip_from_origin(camera, origin_);
        {
            const gpu::ScopedPass pass(
                frame,
                fmt::format("planar/{}/sum", light_.name),
                sum_.target(),
                {.color = glm::vec4(0.0F), .stencil = 0, .area = round});
            for (const auto& [serving, area] : soft) {
                const auto open = [&, &one = *serving, &place = area] {
                    mark_receiver(frame, target, one, place, PlanarSum::kOpen);
                };
                open();
                add_shadows(frame, *serving, clip, area, open);
                frame.counters().mask_fragments += pixels(area) * serving->casters.samples.size();
                gpu::clear_target(frame, sum_.target(), {.stencil = 0, .area = area});
                frame.counters().stencil_fragments += pixels(area);
            }
        }
        const gpu::ScopedPass pass(frame, fmt::format("planar/{}", light_.name), target.mask);
        gpu::RenderState state = gpu::kScreenState;
        state.blend = gpu::Blend::min;
        state.scissor = round;
        frame.state(state);
        sum_.texture().bind(UNIT_VISIBILITY);
        frame.draw_fullscreen(*sum_mask_);
        frame.counters().mask_fragments += pixels(round);
        frame.counters().taps += pixels(round);
    }

    /// What one receiver's casters block, into the sum. The stencil is open on the receiver.
    template <class Open>
    void add_shadows(
        gpu::Frame& frame,
        const Serving& serving,
        const glm::dmat4& clip,
        const gpu::Rect& area,
        Open open) const {
        const auto& samples = serving.casters.samples;
        if (!serving.skirt) {
            sum_.add(frame, draws_, serving.runs, samples, clip, area, open);
            return;
        }
        const gpu::RenderState state = sum_.darkest_state(area);
        skirts_.draw(frame, *serving.skirt, clip, state);
        draws_.draw(frame, {clip, samples.front(), 1.0F}, serving.runs, state);
    }

    /// Shadows that are kept in textures.
    void look_up(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target,
        const std::vector<Shown>& kept) {
        for (const Shown& shown : kept)
            shown.serving->kept->refresh(
                frame, draws_, shown.serving->runs, shown.serving->casters.samples);
        const gpu::ScopedPass pass(frame, fmt::format("planar/{}", light_.name), target.mask);
        target.gbuffer.bind(UNIT_GBUFFER);
        target.depth.bind(UNIT_DEPTH);
        gpu::RenderState state = gpu::kScreenState;
        state.blend = gpu::Blend::min;
        for (const auto& [serving, area] : kept) {
            state.scissor = area;
            serving->kept->texture().look_up(
                frame, *kept_mask_, camera, serving->casters.receiver, state);
        }
    }

    /// Writes `mark` where the receiver is seen.
    void mark_receiver(
        gpu::Frame& frame,
        const render::VisibilityTarget& target,
        const Serving& serving,
        const gpu::Rect& area,
        std::uint8_t mark) {
        gpu::RenderState state = gpu::kScreenState;
        state.color_write = gpu::kWriteNoColor;
        state.scissor = area;
        state.stencil = gpu::Stencil::both(
            {.test = gpu::Compare::greater_equal,
             .on_pass = gpu::StencilOp::replace,
             .reference = mark});
        frame.state(state);
        target.gbuffer.bind(UNIT_GBUFFER);
        mark_->set("receiver", serving.casters.receiver);
        frame.draw_fullscreen(*mark_);
        frame.counters().stencil_fragments += pixels(area);
        frame.counters().taps += pixels(area);
    }

    [[nodiscard]] gpu::RenderState shading_state(const gpu::Rect& area, std::uint8_t mark) const {
        gpu::RenderState state;
        state.depth_write = false;
        state.depth_test = tagged() ? gpu::Compare::always : gpu::Compare::greater_equal;
        state.scissor = area;
        state.clip_distances = 2;
        if (!tagged()) return state;
        // A pixel that is dark already loses its mark; marks that stay are higher than all others.
        const bool fresh = remedies_.on(Remedy::planar_fresh_stencil);
        state.stencil = gpu::Stencil::both(
            {.test = gpu::Compare::equal,
             .on_pass = fresh ? gpu::StencilOp::zero : gpu::StencilOp::invert,
             .reference = mark});
        return state;
    }

    /// Leaves the stencil as it was found.
    void wipe(gpu::Frame& frame, const gpu::Framebuffer& target, const gpu::Rect& marked) const {
        if (marked.empty() || !tagged() || !remedies_.on(Remedy::planar_fresh_stencil)) return;
        gpu::clear_target(frame, target, {.stencil = 0, .area = marked});
        frame.counters().stencil_fragments += pixels(marked);
    }

    LightView light_;
    Remedies remedies_;
    glm::dvec3 origin_ = {}; ///< of the instances' positions
    glm::ivec2 size_ = {};   ///< of the picture, pixels
    std::vector<Serving> servings_;
    PlanarDraws draws_;
    PlateauDraws skirts_;
    PlanarSum sum_;
    std::map<std::uint32_t, KeptShadow> kept_; ///< by receiver
    const gpu::Program* mark_ = nullptr;
    const gpu::Program* sum_mask_ = nullptr;
    const gpu::Program* kept_mask_ = nullptr;
};

} // namespace

std::unique_ptr<ShadowJob> make_planar_job() {
    return std::make_unique<PlanarJob>();
}

} // namespace shadows
