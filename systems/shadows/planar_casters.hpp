// Which casters a flat receiver's planar shadow is drawn from, where on it they can be seen, and
// from which points of the light.

#pragma once

#include "systems/shadows/plan.hpp"
#include "systems/shadows/planar_projection.hpp"
#include "systems/shadows/remedies.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace shadows {

/// A point of the light, as it shines on a plane.
struct PlanarSample {
    LightView light; ///< without a size
    LitPlane plane;
    double weight = 1.0; ///< its part of the light that arrives; all add up to 1
};

/// A caster that boxes stand for.
struct BoxedCaster {
    std::uint32_t mesh = 0;
    std::size_t set = 0; ///< index into the mesh's box_sets
    glm::dmat4 world_from_mesh = glm::dmat4(1.0);
};

struct PlanarCasters {
    std::uint32_t receiver = 0;          ///< id
    LitPlane plane;                      ///< as the light's centre shines on it
    engine::WorldAabb bounds;            ///< of the shadow on the receiver, with its penumbra
    std::vector<std::uint32_t> entities; ///< entity values of those drawn as they are
    std::vector<BoxedCaster> boxed;      ///< the others
    std::vector<PlanarSample> samples;   ///< one for a hard shadow
};

/// Casters of the groups whose shadows can fall on the receiver; the receiver's own mesh is one of
/// them where it rises over the plane. None where nothing is to be drawn.
/// @param groups of the light
/// @param entry which of them, and how
/// @param origin as lit_plane has it
/// @pre receiver.flat
/// Cost: one projected box per caster, ten where the light has a size.
std::optional<PlanarCasters> planar_casters(
    const ShadowScene& scene,
    const LightView& light,
    const ReceiverView& receiver,
    std::span<const CasterGroup> groups,
    const PlanEntry& entry,
    const glm::dvec3& origin,
    const Remedies& remedies);

/// Whether a plan's shadow is a plateau: wished for, and no worse than what is accepted.
bool draws_plateau(const PlanEntry& entry, const Remedies& remedies);

/// Points of a light with what each gives to a plane, (N.L)+ of their sum; those below its horizon
/// are left out.
/// @param seen_from where the shadow falls
std::vector<PlanarSample> planar_samples(
    const LightView& light,
    const ReceiverView& receiver,
    const glm::dvec3& seen_from,
    int count,
    const glm::dvec3& origin,
    const Remedies& remedies);

} // namespace shadows
