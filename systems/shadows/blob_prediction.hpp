// What blobs would be worth for a pair: their error and cost. Everything has a box, so only a lamp
// beside its caster is out of their domain.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

namespace shadows {

/// Cost: none per caster; the largest of the group stands for all.
/// Errors: the ball round a caster holds the lamp.
engine::Result<Prediction> predict_blob(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
