#include "engine/script/sandbox.hpp"

#include "engine/core/text.hpp"
#include "engine/script/guarded_library.hpp"
#include "engine/script/lua_state.hpp"
#include "engine/script/raise.hpp"

#include <fmt/format.h>
#include <lua.hpp>

#include <algorithm>
#include <array>

namespace script {

namespace {

const char kGlobalsKey = 0; ///< its address is the key of the globals in the registry

/// Names of plain Lua that people reach for first, and what to do without them.
constexpr std::array kLeftOut = {
    "io",
    "os",
    "debug",
    "package",
    "load",
    "loadstring",
    "dofile",
    "next",
    "unpack",
    "loadfile",
    "collectgarbage",
    "_G",
    "warn",
    "setfenv"};

std::string unknown_name(lua_State* lua, std::string_view name) {
    if (std::find(kLeftOut.begin(), kLeftOut.end(), name) != kLeftOut.end())
        return fmt::format("'{}' is left out of the Lua that levels see", name);
    std::vector<std::string_view> known;
    push_globals(lua);
    for (lua_pushnil(lua); lua_next(lua, -2) != 0; lua_pop(lua, 1))
        known.emplace_back(lua_tostring(lua, -2));
    std::sort(known.begin(), known.end());
    lua_pop(lua, 1);
    return fmt::format("unknown name '{}'{}", name, engine::did_you_mean(name, known));
}

std::string key_text(lua_State* lua, int index) {
    std::size_t size = 0;
    if (lua_type(lua, index) != LUA_TSTRING) return luaL_typename(lua, index);
    const char* text = lua_tolstring(lua, index, &size);
    return {text, size};
}

int read_global(lua_State* lua) {
    push_globals(lua);
    lua_pushvalue(lua, 2);
    if (lua_rawget(lua, -2) != LUA_TNIL) return 1;
    raise(lua, unknown_name(lua, key_text(lua, 2)));
}

int write_global(lua_State* lua) {
    const std::string name = key_text(lua, 2);
    raise(lua, fmt::format("'{0}' is assigned but not declared; write: local {0} = ...", name));
}

/// Keeps the members of the library at the top of the stack that are in `names`, and no others.
void keep_only(lua_State* lua, const std::vector<std::string_view>& names) {
    std::vector<std::string> removed;
    for (lua_pushnil(lua); lua_next(lua, -2) != 0; lua_pop(lua, 1)) {
        const std::string key = lua_tostring(lua, -2);
        if (std::find(names.begin(), names.end(), key) == names.end()) removed.push_back(key);
    }
    for (const std::string& key : removed) {
        lua_pushnil(lua);
        lua_setfield(lua, -2, key.c_str());
    }
}

void seed_random(lua_State* lua, long long seed) {
    lua_getfield(lua, -1, "randomseed");
    lua_pushinteger(lua, seed);
    lua_pushinteger(lua, 0);
    lua_call(lua, 2, 0);
}

void add_library(lua_State* lua, const SandboxName& library, lua_CFunction open, long long seed) {
    const std::string name(library.name);
    luaL_requiref(lua, name.c_str(), open, 0);
    if (name == "math") seed_random(lua, seed);
    keep_only(lua, library.members);
    guard_library(lua, library.name);
    lua_setfield(lua, -2, name.c_str());
}

void add_base(lua_State* lua) {
    lua_pushcfunction(lua, luaopen_base);
    lua_call(lua, 0, 1);
    for (const SandboxName& global : sandbox_names()) {
        if (!global.members.empty()) continue;
        lua_getfield(lua, -1, std::string(global.name).c_str());
        lua_setfield(lua, -3, std::string(global.name).c_str());
    }
    lua_pop(lua, 1);
    guard_library(lua, "");
}

/// Scripts share the metatable of strings with nobody.
void lock_strings(lua_State* lua) {
    lua_pushliteral(lua, "");
    lua_getmetatable(lua, -1);
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 2);
}

} // namespace

const std::vector<SandboxName>& sandbox_names() {
    static const std::vector<SandboxName> names = {
        {"_VERSION", {}},
        {"assert", {}},
        {"error", {}},
        {"getmetatable", {}},
        {"ipairs", {}},
        {"pairs", {}},
        {"pcall", {}},
        {"print", {}},
        {"rawequal", {}},
        {"rawget", {}},
        {"rawlen", {}},
        {"rawset", {}},
        {"select", {}},
        {"setmetatable", {}},
        {"tonumber", {}},
        {"tostring", {}},
        {"type", {}},
        {"xpcall", {}},
        {"coroutine", {"create", "isyieldable", "resume", "running", "status", "wrap", "yield"}},
        {"math", {"abs",  "acos",       "asin",      "atan", "ceil", "cos",    "deg",
                  "exp",  "floor",      "fmod",      "huge", "log",  "max",    "maxinteger",
                  "min",  "mininteger", "modf",      "pi",   "rad",  "random", "sin",
                  "sqrt", "tan",        "tointeger", "type", "ult"}},
        {"string",
         {"byte",
          "char",
          "find",
          "format",
          "gmatch",
          "gsub",
          "len",
          "lower",
          "match",
          "pack",
          "packsize",
          "rep",
          "reverse",
          "sub",
          "unpack",
          "upper"}},
        {"table", {"concat", "insert", "move", "pack", "remove", "sort", "unpack"}},
        {"utf8", {"char", "charpattern", "codepoint", "codes", "len", "offset"}}};
    return names;
}

void push_globals(lua_State* lua) {
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &kGlobalsKey);
}

void push_sandbox(lua_State* lua, long long seed) {
    luaL_checkstack(lua, 20, nullptr);
    lua_newtable(lua);
    lua_pushvalue(lua, -1);
    lua_rawsetp(lua, LUA_REGISTRYINDEX, &kGlobalsKey);
    add_base(lua);
    for (const SandboxName& global : sandbox_names()) {
        if (global.name == "coroutine") add_library(lua, global, luaopen_coroutine, seed);
        if (global.name == "math") add_library(lua, global, luaopen_math, seed);
        if (global.name == "string") add_library(lua, global, luaopen_string, seed);
        if (global.name == "table") add_library(lua, global, luaopen_table, seed);
        if (global.name == "utf8") add_library(lua, global, luaopen_utf8, seed);
    }
    lua_pop(lua, 1);
    lock_strings(lua);

    lua_newtable(lua);
    lua_createtable(lua, 0, 3);
    lua_pushcfunction(lua, &read_global);
    lua_setfield(lua, -2, "__index");
    lua_pushcfunction(lua, &write_global);
    lua_setfield(lua, -2, "__newindex");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_setmetatable(lua, -2);
}

} // namespace script
