// Plans as JSON: what plans.json holds, and what captures compare exactly.

#pragma once

#include "systems/shadows/plan.hpp"

#include <string>

namespace shadows {

/// Names instead of ids, numbers rounded to 1/1024, one object per pair with its entries, reasons
/// and rejections. Pairs that nothing can darken are not in it.
std::string plans_to_json(const ShadowScene& scene, const FramePlan& plan);

} // namespace shadows
