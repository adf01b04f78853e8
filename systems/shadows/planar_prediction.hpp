// What planar shadows would be worth for a pair: their domain, error and cost.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

namespace shadows {

/// Errors: the receiver is not flat; a sun grazes it, so that the shadow has no useful end.
engine::Result<Prediction> predict_planar(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
