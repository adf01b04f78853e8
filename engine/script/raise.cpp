#include "engine/script/raise.hpp"

#include <lua.hpp>

#include <cstdlib>

namespace script {

void raise(lua_State* lua, const std::string& message) {
    luaL_where(lua, 1);
    lua_pushlstring(lua, message.data(), message.size());
    lua_concat(lua, 2);
    lua_error(lua);
    std::abort(); // lua_error does not return
}

} // namespace script
