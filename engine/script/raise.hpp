// Lua errors from C++: an exception of Lua's own, so destructors run on the way.

#pragma once

#include <string>

struct lua_State;

namespace script {

/// Ends the running Lua function with "place: message", where the place is that of its caller.
/// @pre called inside a protected call
[[noreturn]] void raise(lua_State* lua, const std::string& message);

} // namespace script
