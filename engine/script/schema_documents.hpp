// Texts made from the scene schema: what editors, linters and people read. They are committed, and
// a test fails when one of them is stale.

#pragma once

#include "engine/core/schema.hpp"

#include <string>

namespace script {

/// scripts/meta/gnomon.d.lua: annotations for the Lua language server (LuaCATS).
std::string lua_annotations(const engine::Schema& schema);

/// docs/reference.md: every word that a level may use.
std::string reference_page(const engine::Schema& schema);

} // namespace script
