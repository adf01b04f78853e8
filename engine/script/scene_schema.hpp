// Everything that a level may say: the one place where its words, units, ranges and defaults stand.

#pragma once

#include "engine/core/schema.hpp"

#include <string>
#include <vector>

namespace script {

/// Words that the engine does not know by itself.
struct SceneVocabulary {
    std::vector<std::string> techniques; ///< names; "auto" is added where it makes sense
    std::vector<std::string> filters = {"nearest", "bilinear", "pcf", "pcss"};
    std::vector<std::string> ways = {"geometry", "box", "boxes", "plateau", "texture"};
};

/// Kinds: scene, sun, spot, lamp, model, camera, rule, budget, shadow, light_shadow.
engine::Schema scene_schema(const SceneVocabulary& vocabulary);

} // namespace script
