// All techniques, in the order of techniques.def.

#pragma once

#include "systems/shadows/shadow_technique.hpp"

#include <string_view>
#include <vector>

namespace shadows {

Techniques all_techniques();

/// The technique of that name, or null.
const ShadowTechnique* find_technique(const Techniques& techniques, std::string_view name);

/// "auto" and every technique's name: what a wish for a technique may say.
std::vector<std::string_view> technique_words(const Techniques& techniques);

} // namespace shadows
