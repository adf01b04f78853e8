// Where the shadow of a box can fall: what volumes are scissored to.

#pragma once

#include "systems/shadows/screen_bounds.hpp"
#include "systems/shadows/shadow_scene.hpp"

#include <array>
#include <optional>
#include <vector>

namespace shadows {

/// The part of a caster's swept box that meets one receiver.
struct SweptReach {
    engine::WorldAabb bounds;           ///< of what can be dark, inside the receiver's box
    std::array<glm::dvec3, 16> corners; ///< the swept box there is inside their convex hull
};

/// None when the swept box misses the receiver's. Conservative.
std::optional<SweptReach> swept_reach(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver);

/// The pixels in which a shadow can be seen. Conservative.
PixelBox swept_pixels(const scene::CameraView& camera, const std::vector<SweptReach>& reaches);

} // namespace shadows
