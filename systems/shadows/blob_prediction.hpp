// What blobs would be worth for a pair: their error and cost. They have no domain: everything has a
// box.

#pragma once

#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

namespace shadows {

/// Cost: none per caster; the largest of the group stands for all.
Prediction predict_blob(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
