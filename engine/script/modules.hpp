// `require` for scripts: modules shipped with the engine, then files of the level's own folder.

#pragma once

#include <optional>
#include <string_view>

struct lua_State;

namespace script {

/// The text of a module that lies in scripts/ of this project; it is part of the program.
std::optional<std::string_view> shipped_module(std::string_view name);

/// Hands the value at the top of the stack to module `name` as its only argument when it runs;
/// takes it away. Call it protected: it allocates.
void set_module_argument(lua_State* lua, const char* name);

/// The Lua function `require`: "walls" or "parts.walls". Runs a module once and returns what it
/// returned. Raises: a name that could leave the folder, no such module, a module that requires
/// itself.
int require_module(lua_State* lua);

} // namespace script
