// When a simplified caster may stand in for a caster, and how wrong its shadow is then.
//
// A proxy never darkens the surface that it was made from: a mesh's own receivers always get the
// mesh. Nor does it darken what may lie inside its own bulges: a receiver is served when it keeps
// farther away than the proxy's deviation, or is flat with the whole caster on one side of its
// plane. The corners of a proxy are corners of the caster, so it then lies on that side, too, and
// holds no point of the receiver. What is left is an outline that is off by at most the deviation.

#pragma once

#include "systems/shadows/pairs.hpp"

#include <string>

namespace shadows {

/// @param level from 1 to the number of the caster's proxies
bool proxy_may_serve(const CasterView& caster, int level, const ReceiverView& receiver);

/// How far edges of the shadow are off at most, pixels: the proxy's deviation, as a lamp magnifies
/// it and the camera sees it where the receiver is nearest.
double proxy_error_px(
    const PairView& pair, const CasterGroup& casters, const CasterView& caster, int level);

/// The coarsest proxy that may serve the pair's receiver and is off by `allowance_px` at most, but
/// none finer or coarser than was asked for when it was; 0: the caster itself.
int proxy_level(
    const PairView& pair,
    const CasterGroup& casters,
    const CasterView& caster,
    double allowance_px);

/// Why the level is not the one that was asked for, one clause for people; empty when it is.
/// @pre the pair's wish names a level
std::string why_not_proxy(const PairView& pair, const CasterView& caster, int level);

} // namespace shadows
