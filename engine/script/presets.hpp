// Presets: what a level wishes of shadows in one word, from scripts/gnomon/presets.lua.

#pragma once

#include "engine/core/result.hpp"
#include "engine/script/lua_state.hpp"
#include "engine/script/value.hpp"
#include "engine/script/vocabulary.hpp"

namespace script {

/// The scene with whatever its preset says and it does not say itself; the schema checks both
/// alike. A scene without a preset, or with an unknown one, stays as it is.
/// Errors: the caps of the script.
engine::Result<Value>
filled_by_preset(const Value& scene, LuaState& state, const Vocabulary& vocabulary);

} // namespace script
