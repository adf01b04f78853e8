// Casters of one light in groups: each hero alone, the others by where they stand. A group is the
// unit that the picker gives to a technique.

#pragma once

#include "systems/shadows/shadow_scene.hpp"

#include <cstdint>
#include <vector>

namespace shadows {

inline constexpr std::size_t kMaxGroupsPerLight = 64;

struct CasterGroup {
    std::vector<std::uint32_t> casters; ///< indices into ShadowScene::casters, rising
    engine::WorldAabb bounds;
    double largest_radius = 0.0; ///< of the spheres round the casters' boxes, metres
    bool hero = false;
    std::uint64_t triangles = 0;
};

/// The casters that can stand between the light and something, in at most kMaxGroupsPerLight
/// groups: heroes first, then floors, walls and whatever else is half as large as everything
/// together, each alone, then clusters made by halving the longest side at the median until there
/// are enough. Same scene, same groups. When there are more heroes than groups, the last group
/// holds the remaining ones together.
std::vector<CasterGroup> group_casters(const ShadowScene& scene, const LightView& light);

} // namespace shadows
