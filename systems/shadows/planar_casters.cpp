#include "systems/shadows/planar_casters.hpp"

namespace shadows {

namespace {

/// Without a remedy everything is drawn anywhere, but for the receiver's own mesh.
bool unclipped(const Remedies& remedies) {
    return !remedies.on(Remedy::planar_stencil) || !remedies.on(Remedy::planar_anti_shadow_clip)
           || !remedies.on(Remedy::planar_behind_clip);
}

} // namespace

std::optional<PlanarCasters> planar_casters(
    const ShadowScene& scene,
    const LightView& light,
    const ReceiverView& receiver,
    std::span<const CasterGroup> groups,
    std::span<const std::uint32_t> chosen,
    const glm::dvec3& origin,
    const Remedies& remedies) {
    const auto plane = lit_plane(light, receiver, origin);
    if (!plane) return std::nullopt;
    PlanarCasters casters{receiver.id, *plane, {}, {}};
    for (const std::uint32_t group : chosen)
        for (const std::uint32_t index : groups[group].casters) {
            const CasterView& caster = scene.casters[index];
            const bool all = unclipped(remedies) && caster.id != receiver.entity;
            const engine::WorldAabb bounds =
                all ? receiver.bounds : shadow_bounds(light, *plane, receiver, caster.bounds);
            if (bounds.empty()) continue;
            casters.bounds.grow(bounds);
            casters.entities.push_back(caster.id);
        }
    if (casters.entities.empty()) return std::nullopt;
    return casters;
}

} // namespace shadows
