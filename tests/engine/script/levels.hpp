// What the tests of the script host share: words, and levels from text.

#pragma once

#include "engine/script/scene_loader.hpp"

#include <string>
#include <string_view>

namespace script::testing {

/// The techniques of this project, as its registry lists them.
inline SceneVocabulary words() {
    SceneVocabulary vocabulary;
    vocabulary.techniques = {
        "auto",
        "none",
        "blob",
        "planar",
        "shadow_texture",
        "volume",
        "cascaded_map",
        "spot_map",
        "cube_map",
        "traced"};
    return vocabulary;
}

/// A level named yard.lua whose first line makes `g`.
inline LoadedScene load(std::string_view after_require, const LuaLimits& limits = {}) {
    return load_scene_text(
        "local g = require \"gnomon\"\n" + std::string(after_require), "yard.lua", words(), limits);
}

/// A scene that holds `parts`, on line 2.
inline LoadedScene load_parts(const std::string& parts) {
    return load("return g.scene { " + parts + " }");
}

} // namespace script::testing
