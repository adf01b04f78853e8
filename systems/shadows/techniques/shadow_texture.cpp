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
#include "systems/shadows/maps/map_resolution.hpp"
#include "systems/shadows/techniques/group_textures.hpp"

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

/// Textures keep their size until they are too coarse, or four times as large as they need to be.
TextureLayout
kept(const TextureLayout& has, const TextureLayout& wanted, const scene::ShadowWish& wish) {
    TextureLayout layout = wanted;
    if (!wish.map_size && still_right(has.size, wanted.size)) layout.size = has.size;
    if (!wish.samples && has.samples > 1 && still_right(has.samples, wanted.samples))
        layout.samples = has.samples;
    return layout;
}

class ShadowTextureJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_name_ = request.scene.lights[request.light].name;
        const auto wanted = wanted_by(request);
        std::erase_if(textures_, [&](const auto& kept) { return !wanted.contains(kept.first); });
        for (const auto& [group, want] : wanted) {
            GroupTextures& textures = textures_[group];
            const TextureLayout layout = kept(textures.layout(), want.layout, request.wish);
            if (auto updated = textures.update(request, request.groups[group], want.plans, layout);
                !updated)
                return updated;
        }
        picture_ = {request.scene.camera.width, request.scene.camera.height};
        return {};
    }

    [[nodiscard]] bool still_serves(const ShadowRequest& request) const override {
        const auto wanted = wanted_by(request);
        return std::all_of(wanted.begin(), wanted.end(), [&](const auto& want) {
            const auto found = textures_.find(want.first);
            if (found == textures_.end()) return false;
            const TextureLayout layout = found->second.layout();
            return kept(layout, want.second.layout, request.wish) == layout;
        });
    }

    engine::Result<void> render(
        gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) override {
        bool soft = false;
        for (auto& [group, textures] : textures_) {
            if (auto drawn = textures.render(frame, shaders, geometry, samples_); !drawn)
                return drawn;
            soft = soft || textures.is_soft();
        }
        return soft ? sum_.prepare(shaders, fmt::format("{}/{}/sum", light_name_, kName), picture_)
                    : engine::Result<void>();
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        target.gbuffer.bind(UNIT_GBUFFER);
        target.facets.bind(UNIT_FACETS);
        target.depth.bind(UNIT_DEPTH);
        for (const auto& [group, textures] : textures_) {
            const auto areas = textures.areas(camera, target.area);
            if (areas.empty()) continue;
            if (textures.is_soft()) {
                const gpu::ScopedPass pass(
                    frame,
                    fmt::format("{}/{}/sum", light_name_, kName),
                    sum_.target(),
                    {.color = glm::vec4(0.0F), .area = areas.front()});
                textures.look_up(frame, camera, areas);
            }
            const gpu::ScopedPass pass(
                frame, fmt::format("{}/{}/mask", light_name_, kName), target.mask);
            if (textures.is_soft())
                sum_.compose(frame, areas);
            else
                textures.look_up(frame, camera, areas);
        }
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
        std::size_t sum = samples_.gpu_bytes() + sum_.gpu_bytes();
        for (const auto& [group, textures] : textures_)
            sum += textures.gpu_bytes();
        return sum;
    }

private:
    std::string light_name_;
    glm::ivec2 picture_ = {};
    std::map<std::uint32_t, GroupTextures> textures_; ///< by group
    TextureSamples samples_;
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
