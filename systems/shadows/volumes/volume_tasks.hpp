// What a light's volumes have to do in a frame, as the plans have it: which caster, or which of its
// proxies, darkens which receivers, and what can be counted in one stencil.

#pragma once

#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/volumes/swept_bounds.hpp"

#include <cstdint>
#include <vector>

namespace shadows {

/// One volume.
struct VolumeTask {
    std::uint32_t caster = 0;             ///< index into ShadowScene::casters
    int level = 0;                        ///< of its proxy; 0: the caster itself
    std::vector<std::uint32_t> receivers; ///< ids, in the order of the plans
    std::vector<SweptReach> reaches;      ///< one per receiver
};

/// Volumes that are counted together, and then darken the receivers of all of them.
struct VolumePass {
    std::vector<VolumeTask> tasks;        ///< by caster
    std::vector<std::uint32_t> receivers; ///< ids, rising
};

/// Casters themselves first, all in one pass: what they darken is dark, whoever asked. A proxy
/// joins the first pass in which every volume may darken every receiver, itself included. Unless
/// someone named a level, a caster that is drawn itself for one receiver serves all: it costs no
/// more.
std::vector<VolumePass> volume_passes(const ShadowRequest& request);

} // namespace shadows
