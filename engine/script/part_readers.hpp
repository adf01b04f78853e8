// Readers of single parts of a level: a light, a model, a camera, a rule.

#pragma once

#include "engine/scene/description.hpp"
#include "engine/script/table_reader.hpp"

namespace script {

// Each reads everything that its kind may say, and finishes the reader. Names that were not given
// stay empty.
scene::LightDescription read_sun(TableReader& reader);
scene::LightDescription read_spot(TableReader& reader);
scene::LightDescription read_lamp(TableReader& reader);
scene::ModelDescription read_model(TableReader& reader);
scene::CameraDescription read_camera(TableReader& reader);
scene::RuleDescription read_rule(TableReader& reader);
scene::PathDescription read_path(TableReader& reader);
scene::PlayerDescription read_player(TableReader& reader);

/// The wishes in field "shadow".
scene::ShadowWish read_shadow(TableReader& reader);

} // namespace script
