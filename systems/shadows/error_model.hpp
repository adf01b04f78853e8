// Predicted errors on screen, from bounds alone: pure arithmetic, about a hundred operations per
// pair.

#pragma once

#include "systems/shadows/pairs.hpp"

namespace shadows {

/// The shadow of some casters on a receiver, as the camera would see it.
struct ShadowFootprint {
    double area_px = 0.0;   ///< of the shadow on screen, at most the receiver's own
    double length_px = 0.0; ///< of its edge
};

/// How much larger the shadow is than its caster: (a + b) / a with a from the light to the caster
/// and b from there to the receiver; 1 for directional lights.
double magnification(const PairView& pair, const CasterGroup& casters);

/// Area on screen of a box's bounding sphere, pixels; at most the whole picture.
double screen_area_px(const scene::CameraView& camera, const engine::WorldAabb& box);

/// The shadow is taken as the disc that the casters' bounding sphere throws, magnified by the
/// distance behind it. Source: bounds of the shadow area A and edge length L = 2 sqrt(pi A) of a
/// disc.
ShadowFootprint shadow_footprint(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
