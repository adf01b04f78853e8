// Shadow textures: a group of casters, drawn from the light into a texture of its own and projected
// on whatever lies behind. Right for small groups over large receivers, flat or curved: texels are
// spent on the casters' outline alone, as many as the shadow needs where it falls, and still things
// cost nothing. A light with a size is a sum of points with a texture each. Its artefacts: what is
// thinner than half a texel has no shadow; and a shadow ends at the first surface that receives,
// even one that lets light through because it casts nothing.
//
// A texel knows which share of it is covered, and how deep. An edge lies where half is covered,
// which stays a line under magnification; a point is dark only behind the caster.
//
// Sources: M. Segal et al., "Fast Shadows and Lighting Effects Using Texture Mapping", 1992;
// C. Green, "Improved Alpha-Tested Magnification for Vector Textures and Special Effects", 2007.

#include "engine/gpu/pass.hpp"
#include "systems/shadows/light_samples.hpp"
#include "systems/shadows/maps/map_resolution.hpp"
#include "systems/shadows/techniques/group_textures.hpp"
#include "systems/shadows/techniques/light_sum.hpp"
#include "systems/shadows/techniques/rectangles.hpp"
#include "systems/shadows/textures/texture_prediction.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>

#include <algorithm>
#include <limits>
#include <map>

namespace shadows {

namespace {

constexpr std::string_view kName = "shadow_texture";
/// Texels that a look-up may miss the edge of a contact by, see texel_at().
constexpr double kReach = 0.5;

/// What the plans want of one group.
struct Wanted {
    std::vector<const Plan*> plans;
    TextureLayout layout;
};

/// By group of the light.
std::map<std::uint32_t, Wanted> wanted_by(const ShadowRequest& request) {
    const ShadowScene& scene = request.scene;
    std::map<std::uint32_t, Wanted> wanted;
    for (const Plan* plan : request.plans) {
        const PairView pair{
            scene,
            scene.lights[request.light],
            scene.receiver(plan->receiver),
            request.wish,
            plan->budget_px};
        for (const PlanEntry& entry : plan->entries) {
            if (entry.technique != kName) continue;
            for (const std::uint32_t group : entry.caster_groups) {
                Wanted& want = wanted[group];
                want.plans.push_back(plan);
                want.layout = finer(want.layout, texture_layout(pair, request.groups[group]));
            }
        }
    }
    return wanted;
}

/// Enough, and not more than twice as much.
bool still_right(int has, int wanted) {
    return has >= wanted && has <= 2 * wanted;
}

/// Points of the light for all groups that need more than one.
int samples_for_all(const std::map<std::uint32_t, Wanted>& wanted) {
    int samples = 1;
    int most = std::numeric_limits<int>::max();
    for (const auto& [group, want] : wanted) {
        if (want.layout.samples == 1) continue;
        samples = std::max(samples, want.layout.samples);
        most = std::min(most, most_samples(want.layout.size));
    }
    return std::min(samples, most);
}

class ShadowTextureJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_name_ = request.scene.lights[request.light].name;
        remedies_ = request.remedies;
        picture_ = {request.scene.camera.width, request.scene.camera.height};
        const auto wanted = wanted_by(request);
        std::erase_if(textures_, [&](const auto& kept) { return !wanted.contains(kept.first); });
        engine::WorldAabb casters;
        for (const auto& [group, want] : wanted)
            casters.grow(request.groups[group].bounds);
        samples_ = kept_samples(samples_for_all(wanted), request.wish);
        const LightView& light = request.scene.lights[request.light];
        const auto points = [&](int count) {
            return light_samples(light, casters.centre(), count, SamplePattern::hammersley);
        };
        // The same for all groups, so that they can be added up.
        points_ = points(remedies_.on(Remedy::texture_light_points) ? samples_ : 1);
        const auto middle = points(1);
        for (const auto& [group, want] : wanted) {
            GroupTextures& textures = textures_[group];
            if (auto updated = textures.update(
                    request,
                    request.groups[group],
                    want.plans,
                    want.layout.samples > 1 ? points_ : middle,
                    kept_size(textures.size(), want.layout.size, request.wish));
                !updated)
                return updated;
        }
        return {};
    }

    [[nodiscard]] bool may_wait() const override { return true; }

    [[nodiscard]] bool still_serves(const ShadowRequest& request) const override {
        const scene::CameraView& camera = request.scene.camera;
        if (picture_ != glm::ivec2(camera.width, camera.height)) return false;
        const auto wanted = wanted_by(request);
        if (kept_samples(samples_for_all(wanted), request.wish) != samples_) return false;
        return std::all_of(wanted.begin(), wanted.end(), [&](const auto& want) {
            const auto found = textures_.find(want.first);
            if (found == textures_.end()) return false;
            const GroupTextures& textures = found->second;
            const TextureLayout& layout = want.second.layout;
            return kept_size(textures.size(), layout.size, request.wish) == textures.size()
                   && (textures.is_soft() || layout.samples == 1 || points_.size() == 1);
        });
    }

    engine::Result<void> render(
        gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) override {
        for (auto& [group, textures] : textures_)
            if (auto drawn = textures.render(frame, shaders, geometry, drawn_samples_); !drawn)
                return drawn;
        if (points_.size() == 1) return {};
        return sum_.prepare(shaders, name_of("sum"), picture_, points_);
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        target.gbuffer.bind(UNIT_GBUFFER);
        target.facets.bind(UNIT_FACETS);
        target.depth.bind(UNIT_DEPTH);
        std::vector<const GroupTextures*> soft;
        for (const auto& [group, textures] : textures_)
            if (textures.is_soft()) soft.push_back(&textures);
        if (remedies_.on(Remedy::texture_union))
            darken_softly(frame, camera, target, soft);
        else
            for (const GroupTextures* textures : soft)
                darken_softly(frame, camera, target, {textures});
        const gpu::ScopedPass pass(frame, name_of("mask"), target.mask);
        gpu::RenderState state = gpu::kScreenState;
        state.blend = gpu::Blend::min;
        for (const auto& [group, textures] : textures_)
            if (!textures.is_soft())
                textures.look_up(frame, camera, 0, textures.areas(camera, target.area), state);
    }

    [[nodiscard]] Resolution
    resolution(const scene::CameraView& camera, const SurfacePoint& point) const override {
        Resolution coarsest;
        for (const auto& [group, textures] : textures_) {
            if (!holds(textures.view(), point.position)) continue;
            const auto texel = std::visit(
                [&](const auto& view) { return texel_at(view, point, kReach); }, textures.view());
            coarsest = coarser(coarsest, on_screen(camera, point, texel));
        }
        return coarsest;
    }

    [[nodiscard]] std::size_t gpu_bytes() const override {
        std::size_t sum = drawn_samples_.gpu_bytes() + sum_.gpu_bytes();
        for (const auto& [group, textures] : textures_)
            sum += textures.gpu_bytes();
        return sum;
    }

private:
    /// Textures keep their size until they are too coarse, or four times as large as they need be.
    static int kept_size(int has, int wanted, const scene::ShadowWish& wish) {
        return !wish.map_size && still_right(has, wanted) ? has : wanted;
    }
    [[nodiscard]] int kept_samples(int wanted, const scene::ShadowWish& wish) const {
        return !wish.samples && samples_ > 1 && still_right(samples_, wanted) ? samples_ : wanted;
    }

    [[nodiscard]] std::string name_of(std::string_view pass) const {
        return fmt::format("{}/{}/{}", light_name_, kName, pass);
    }

    /// Of some groups together: what is hidden by two is hidden once.
    void darken_softly(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target,
        const std::vector<const GroupTextures*>& groups) const {
        std::vector<std::vector<gpu::Rect>> areas;
        gpu::Rect round;
        for (const GroupTextures* group : groups) {
            areas.push_back(group->areas(camera, target.area));
            for (const gpu::Rect& area : areas.back())
                round = hull(round, area);
        }
        if (round.empty()) return;
        {
            const gpu::ScopedPass pass(
                frame,
                name_of("sum"),
                sum_.target(),
                {.color = glm::vec4(0.0F), .stencil = 0, .area = round});
            for (std::size_t point = 0; point < points_.size(); ++point)
                for (std::size_t i = 0; i < groups.size(); ++i)
                    groups[i]->look_up(frame, camera, point, areas[i], sum_.adding(point));
        }
        const gpu::ScopedPass pass(frame, name_of("mask"), target.mask);
        sum_.compose(frame, camera, round);
    }

    std::string light_name_;
    Remedies remedies_;
    glm::ivec2 picture_ = {};
    int samples_ = 0;
    std::vector<LightView> points_;                   ///< of the light, for soft groups
    std::map<std::uint32_t, GroupTextures> textures_; ///< by group
    TextureSamples drawn_samples_;
    LightSum sum_;
};

class ShadowTexture final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            kName, "casters drawn into a texture of their own, projected on what lies behind"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        return predict_texture(pair, casters);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<ShadowTextureJob>();
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_shadow_texture() {
    return std::make_unique<ShadowTexture>();
}

} // namespace shadows
