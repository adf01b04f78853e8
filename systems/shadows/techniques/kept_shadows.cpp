#include "systems/shadows/techniques/kept_shadows.hpp"

#include <algorithm>

namespace shadows {

namespace {

/// A texture that serves fewer frames than this was not worth drawing.
constexpr int kWorthwhileFrames = 4;
/// For so many frames a shadow that moved is projected.
constexpr int kRestlessFrames = 16;

} // namespace

KeptFrom
kept_from(const ShadowRequest& request, const PlanEntry& entry, const PlanarCasters& casters) {
    const ShadowScene& scene = request.scene;
    const LightView& light = scene.lights[request.light];
    const auto& registry = request.world.registry;
    KeptFrom from;
    for (const std::uint32_t group : entry.caster_groups)
        for (const std::uint32_t index : request.groups[group].casters) {
            const CasterView& caster = scene.casters[index];
            from.casters.push_back({caster.id, caster.world_from_mesh});
            if (registry.try_get<scene::PosedMesh>(ecs::Entity{caster.id}) != nullptr)
                from.poses = registry.version<scene::PosedMesh>();
        }
    from.kind = light.light.kind;
    from.light_position = light.position;
    from.light_direction = light.direction;
    from.light_size = from.kind == scene::LightKind::directional ? light.light.angular_radius
                                                                 : light.light.radius;
    from.samples = casters.samples.size();
    from.boxes = casters.boxed.size();
    from.rectangle = plane_rectangle(casters.plane, casters.bounds);
    return from;
}

void KeptShadow::follow(KeptFrom from, const glm::ivec2& size, const Remedies& remedies) {
    const bool moved = !(from == from_);
    if (moved && (restless_frames_ > 0 || (!due_ && served_frames_ < kWorthwhileFrames)))
        restless_frames_ = kRestlessFrames;
    const bool keeps_size = fits(size);
    due_ = due_ || moved || !keeps_size || !(remedies_ == remedies);
    if (!keeps_size) size_ = size;
    from_ = std::move(from);
    remedies_ = remedies;
}

bool KeptShadow::fits(const glm::ivec2& size) const {
    const auto one = [](int held, int wanted) { return held >= wanted && held <= 2 * wanted; };
    return one(size_.x, size.x) && one(size_.y, size.y);
}

engine::Result<void> KeptShadow::prepare(const std::string& label) {
    return texture_.prepare(label, from_.rectangle, size_, remedies_);
}

void KeptShadow::refresh(
    gpu::Frame& frame,
    const PlanarDraws& draws,
    const PlanarDraws::Runs& runs,
    std::span<const PlanarSample> samples) {
    if (!due_) return;
    texture_.draw(frame, draws, runs, samples);
    due_ = false;
    served_frames_ = 0;
}

void KeptShadow::pass_frame() {
    served_frames_ = std::min(served_frames_ + 1, kWorthwhileFrames);
    restless_frames_ = std::max(restless_frames_ - 1, 0);
}

} // namespace shadows
