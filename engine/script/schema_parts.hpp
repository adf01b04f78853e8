// Rows and kinds that the parts of the scene schema share.

#pragma once

#include "engine/core/schema.hpp"

#include <string>
#include <vector>

namespace script {

using Numbers = std::vector<double>;

/// Coordinates in metres: a continent; doubles keep nanometres there.
inline constexpr engine::Range kWorld{.min = -1e7, .max = 1e7};

std::vector<engine::Field>
joined(std::vector<engine::Field> fields, std::vector<engine::Field> more);

/// @param what the thing is, for the text
engine::Field name_field(const std::string& what);
engine::Field position_field(Numbers fallback);

engine::Kind sun_kind();
engine::Kind spot_kind();
engine::Kind lamp_kind();

engine::Kind path_kind();
engine::Kind player_kind();
/// How a model goes along a path.
std::vector<engine::Field> follower_fields();

} // namespace script
