// Library functions of Lua that are replaced: some so that the same script does the same
// everywhere, some because they can run for hours inside C, where no limit reaches.

#pragma once

#include <string_view>

struct lua_State;

namespace script {

/// Replaces what must be replaced in the table at the top of the stack.
/// @param library "string", "table"; empty for the globals
void guard_library(lua_State* lua, std::string_view library);

} // namespace script
