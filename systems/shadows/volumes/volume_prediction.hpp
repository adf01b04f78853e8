// What stencil volumes would be worth for a pair: their domain, error and cost.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

namespace shadows {

/// Edges of a caster's silhouette, or of its proxy's, the mean over all directions of light.
/// @param drawn triangles of the one or the other
double outline_edges(const CasterView& caster, std::uint32_t drawn);

/// Faces of a caster's volume over one pixel of the place that its box's shadow can reach, on
/// average: that place is entered once and left once by the box's own volume, and sides are as wide
/// as silhouettes are long.
double crossings(const CasterView& caster);

/// Errors: a caster has holes that only its texture knows; this driver does not count as volumes
/// need it.
engine::Result<Prediction> predict_volume(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
