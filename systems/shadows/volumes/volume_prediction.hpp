// What stencil volumes would be worth for a pair: their domain, error and cost.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

namespace shadows {

/// Edges of a caster's outline, from what is known without looking at it.
double outline_edges(const CasterView& caster);

/// Faces of a caster's volume over one pixel of the place that its shadow can reach: 2 for a convex
/// one, which is entered once and left once.
double crossings(const CasterView& caster);

/// Errors: a caster has holes that only its texture knows; this driver does not count as volumes
/// need it.
engine::Result<Prediction> predict_volume(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
