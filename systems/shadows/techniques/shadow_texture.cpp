// Shadow textures: a group of casters, drawn from the light into a texture of its own and projected
// on whatever lies behind. Right for small groups over large receivers, flat or curved: texels are
// spent on the casters' outline alone, as many as the shadow needs where it falls, and still things
// cost nothing. Its artefacts: edges are hard even where the light is large; what is thinner than
// half a texel has no shadow; and a shadow ends at the first surface that receives, even one that
// lets light through because it casts nothing.
//
// A texel knows which share of it is covered, and how deep. An edge lies where half is covered,
// which stays a line under magnification; a point is dark only behind the caster.
//
// Sources: M. Segal et al., "Fast Shadows and Lighting Effects Using Texture Mapping", 1992;
// C. Green, "Improved Alpha-Tested Magnification for Vector Textures and Special Effects", 2007.

#include "engine/gpu/pass.hpp"
#include "systems/shadows/maps/map_resolution.hpp"
#include "systems/shadows/techniques/caster_texture.hpp"
#include "systems/shadows/textures/texture_prediction.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>

#include <algorithm>
#include <map>

namespace shadows {

namespace {

constexpr std::string_view kName = "shadow_texture";
/// Texels that a look-up may miss the edge of a contact by, see texel_at().
constexpr double kReach = 0.5;

/// What the plans want of one group.
struct Wanted {
    std::vector<const Plan*> plans;
    int size = kSmallestTexture;
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
                want.size = std::max(want.size, texture_size_for(pair, request.groups[group]));
            }
        }
    }
    return wanted;
}

/// A texture keeps its size until it is too coarse, or four times as large as it needs to be.
bool still_right(int size, int wanted, const scene::ShadowWish& wish) {
    return wish.map_size ? size == wanted : size >= wanted && size <= 2 * wanted;
}

class ShadowTextureJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_name_ = request.scene.lights[request.light].name;
        const auto wanted = wanted_by(request);
        std::erase_if(textures_, [&](const auto& kept) { return !wanted.contains(kept.first); });
        for (const auto& [group, want] : wanted) {
            CasterTexture& texture = textures_[group];
            const bool keeps = still_right(texture.size(), want.size, request.wish);
            if (auto updated = texture.update(
                    request, request.groups[group], want.plans, keeps ? texture.size() : want.size);
                !updated)
                return updated;
        }
        return {};
    }

    [[nodiscard]] bool still_serves(const ShadowRequest& request) const override {
        const auto wanted = wanted_by(request);
        return std::all_of(wanted.begin(), wanted.end(), [&](const auto& want) {
            const auto found = textures_.find(want.first);
            return found != textures_.end()
                   && still_right(found->second.size(), want.second.size, request.wish);
        });
    }

    engine::Result<void> render(
        gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) override {
        for (auto& [group, texture] : textures_)
            if (auto drawn = texture.render(frame, shaders, geometry, samples_); !drawn)
                return drawn;
        return {};
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        const gpu::ScopedPass pass(
            frame, fmt::format("{}/{}/mask", light_name_, kName), target.mask);
        target.gbuffer.bind(UNIT_GBUFFER);
        target.facets.bind(UNIT_FACETS);
        target.depth.bind(UNIT_DEPTH);
        gpu::RenderState state = gpu::kScreenState;
        state.blend = gpu::Blend::min;
        for (const auto& [group, texture] : textures_)
            texture.apply(frame, camera, target, state);
    }

    [[nodiscard]] Resolution
    resolution(const scene::CameraView& camera, const SurfacePoint& point) const override {
        Resolution coarsest;
        for (const auto& [group, texture] : textures_) {
            if (!holds(texture.view(), point.position)) continue;
            const auto texel = std::visit(
                [&](const auto& view) { return texel_at(view, point, kReach); }, texture.view());
            coarsest = coarser(coarsest, on_screen(camera, point, texel));
        }
        return coarsest;
    }

    [[nodiscard]] std::size_t gpu_bytes() const override {
        std::size_t sum = samples_.gpu_bytes();
        for (const auto& [group, texture] : textures_)
            sum += texture.gpu_bytes();
        return sum;
    }

private:
    std::string light_name_;
    std::map<std::uint32_t, CasterTexture> textures_; ///< by group
    TextureSamples samples_;
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
