// Which casters a flat receiver's planar shadow is drawn from, and where on it they can be seen.

#pragma once

#include "systems/shadows/plan.hpp"
#include "systems/shadows/planar_projection.hpp"
#include "systems/shadows/remedies.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace shadows {

struct PlanarCasters {
    std::uint32_t receiver = 0; ///< id
    LitPlane plane;
    engine::WorldAabb bounds;            ///< of the shadow on the receiver
    std::vector<std::uint32_t> entities; ///< entity values
};

/// Casters of the groups whose shadows can fall on the receiver; the receiver's own mesh is one of
/// them where it rises over the plane. None where nothing is to be drawn.
/// @param groups of the light
/// @param chosen indices into groups
/// @param origin as lit_plane has it
/// @pre receiver.flat
/// Cost: one projected box per caster.
std::optional<PlanarCasters> planar_casters(
    const ShadowScene& scene,
    const LightView& light,
    const ReceiverView& receiver,
    std::span<const CasterGroup> groups,
    std::span<const std::uint32_t> chosen,
    const glm::dvec3& origin,
    const Remedies& remedies);

} // namespace shadows
