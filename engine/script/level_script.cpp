#include "engine/script/level_script.hpp"

#include <lua.hpp>

namespace script {

namespace {

const char kUpdateKey = 0; ///< its address is the key of on_update in the registry

} // namespace

bool LevelScript::keep_update() {
    lua_State* lua = state_.lua();
    if (lua_type(lua, -1) != LUA_TTABLE) return false;
    lua_pushcfunction(lua, [](lua_State* inner) {
        lua_pushliteral(inner, "on_update");
        lua_rawget(inner, 1);
        lua_pushboolean(inner, lua_isfunction(inner, -1) ? 1 : 0);
        lua_insert(inner, -2);
        lua_rawsetp(inner, LUA_REGISTRYINDEX, &kUpdateKey);
        return 1;
    });
    lua_pushvalue(lua, -2);
    if (!state_.call(1, 1)) return false;
    acts_ = lua_toboolean(lua, -1) != 0;
    lua_pop(lua, 1);
    return acts_;
}

engine::Result<void> LevelScript::update(scene::World& world, float dt) {
    if (!acts_) return {};
    time_ += static_cast<double>(dt);
    state_.limit_calls(kUpdateLimits);
    auto done = world_.during(world, time_, [&] {
        lua_rawgetp(state_.lua(), LUA_REGISTRYINDEX, &kUpdateKey);
        lua_pushnumber(state_.lua(), static_cast<double>(dt));
        return state_.call(1, 0);
    });
    if (done) return {};
    acts_ = false;
    engine::Error error = done.error();
    error.message += "; on_update is not called again";
    if (!state_.traceback().empty()) error.message += "\n" + state_.traceback();
    return error;
}

} // namespace script
