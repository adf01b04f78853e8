// Planar shadows of one light at work.

#pragma once

#include "systems/shadows/shadow_technique.hpp"

namespace shadows {

std::unique_ptr<ShadowJob> make_planar_job();

} // namespace shadows
