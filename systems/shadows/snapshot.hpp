// Copies from the world what shadow decisions need. The only place of the CPU half that reads the
// registry.

#pragma once

#include "engine/scene/receivers.hpp"
#include "engine/scene/world.hpp"
#include "systems/shadows/shadow_scene.hpp"

#include <span>

namespace shadows {

/// @param lights those of the frame, as the renderer lights with them; lights that are off are left
/// out by the caller
ShadowScene take_snapshot(
    const scene::World& world,
    const scene::ReceiverTable& receivers,
    const scene::CameraView& camera,
    std::span<const scene::PlacedLight> lights);

} // namespace shadows
