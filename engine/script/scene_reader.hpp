// From the values that a level returned to a scene description, with every mistake on the way.

#pragma once

#include "engine/core/schema.hpp"
#include "engine/scene/description.hpp"
#include "engine/script/report.hpp"
#include "engine/script/value.hpp"
#include "engine/script/vocabulary.hpp"

#include <vector>

namespace script {

/// @param root what the level returned
/// @param constructed by Table::constructor
/// @param file the level, for mistakes that have no line
/// @return whatever could be read; good only when `report` has no errors
scene::SceneDescription read_scene(
    const Value& root,
    const std::vector<Constructed>& constructed,
    const engine::Schema& schema,
    const std::string& file,
    Report& report);

} // namespace script
