// Pairs of light and receiver that need a decision this frame, and the casters that can darken
// each.

#pragma once

#include "systems/shadows/caster_groups.hpp"

#include <cstdint>
#include <vector>

namespace shadows {

/// One light, one receiver it can reach and the camera may see.
struct Pair {
    std::uint32_t light = 0;    ///< index into ShadowScene::lights
    std::uint32_t receiver = 0; ///< index into ShadowScene::receivers
    std::vector<std::uint32_t>
        groups; ///< indices of the light's groups whose swept bounds meet the receiver, rising
};

/// What a technique may look at when it predicts.
struct PairView {
    const ShadowScene& scene;
    const LightView& light;
    const ReceiverView& receiver;
    const scene::ShadowWish& wish; ///< resolved for the pair
    double budget_px;              ///< the error that is accepted
};

/// True when a caster inside `caster` can darken a point inside `receiver`: the caster's bounds,
/// swept away from the light, meet the receiver's. Conservative: never false for a pair that has a
/// shadow.
bool can_shadow(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver);

/// True when light can arrive in the box at all: within range, and for spots inside the cone.
/// Conservative.
bool can_reach(const LightView& light, const engine::WorldAabb& box);

/// True when a flat receiver faces the light somewhere; always for others. What is turned away is
/// dark without a shadow.
bool faces(const LightView& light, const ReceiverView& receiver);

/// True when something of a box lies on the lit side of a flat receiver; always for others.
bool stands_before(const engine::WorldAabb& caster, const ReceiverView& receiver);

/// Pairs of one light, in the order of the receivers. Pairs without casters are left out: they are
/// fully lit.
/// @param light index into scene.lights
std::vector<Pair>
find_pairs(const ShadowScene& scene, std::uint32_t light, const std::vector<CasterGroup>& groups);

} // namespace shadows
