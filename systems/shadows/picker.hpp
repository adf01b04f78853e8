// For each pair the cheapest technique in its domain whose predicted error is inside the budget,
// and why. Pure: plain values in, plain values out, the same on every machine and independent of
// the order of entities.

#pragma once

#include "systems/shadows/cost_model.hpp"
#include "systems/shadows/shadow_settings.hpp"
#include "systems/shadows/shadow_technique.hpp"

namespace shadows {

/// Decides every pair of the frame.
FramePlan pick(
    const ShadowScene& scene,
    const ShadowSettings& settings,
    const Techniques& techniques,
    const DeviceProfile& profile);

} // namespace shadows
