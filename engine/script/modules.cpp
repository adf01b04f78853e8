#include "engine/script/modules.hpp"

#include "engine/script/lua_state.hpp"
#include "engine/script/raise.hpp"
#include "engine/script/text_file.hpp"

#include <fmt/format.h>
#include <lua.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace script {

namespace {

namespace fs = std::filesystem;

const char kModulesKey = 0;   ///< its address is the key of the loaded modules in the registry
const char kArgumentsKey = 0; ///< the same for what the engine hands to modules

/// Pushes the table that the registry holds under `key`, made on first use.
void push_table(lua_State* lua, const void* key) {
    if (lua_rawgetp(lua, LUA_REGISTRYINDEX, key) != LUA_TNIL) return;
    lua_pop(lua, 1);
    lua_newtable(lua);
    lua_pushvalue(lua, -1);
    lua_rawsetp(lua, LUA_REGISTRYINDEX, key);
}

/// "parts.walls": words of letters, digits, _ and -, with single dots between them.
bool is_module_name(std::string_view name) {
    const auto plain = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z')
               || (letter >= '0' && letter <= '9') || letter == '_' || letter == '-'
               || letter == '.';
    };
    return !name.empty() && name.size() <= 128 && std::all_of(name.begin(), name.end(), plain)
           && name.front() != '.' && name.back() != '.'
           && name.find("..") == std::string_view::npos;
}

/// "parts.walls": parts/walls.lua.
std::string relative_file(std::string name) {
    std::replace(name.begin(), name.end(), '.', '/');
    return name + ".lua";
}

/// Pushes the compiled module that lies below `folder`.
void load_file(lua_State* lua, const fs::path& folder, const std::string& name) {
    const fs::path file = folder / relative_file(name);
    std::error_code failed;
    if (!fs::is_regular_file(file, failed))
        raise(lua, fmt::format("no module '{}': there is no file {}", name, file.generic_string()));
    const fs::path root = fs::canonical(folder, failed);
    const fs::path real = fs::canonical(file, failed);
    const auto [rest_of_root, rest] =
        std::mismatch(root.begin(), root.end(), real.begin(), real.end());
    if (failed || rest_of_root != root.end())
        raise(
            lua,
            fmt::format(
                "module '{}' is a link that leads out of {}", name, folder.generic_string()));

    const auto text = read_text_file(file);
    if (!text) raise(lua, engine::to_string(text.error()));
    LuaState::of(lua).add_file(file);
    LuaState::of(lua).load_or_raise(lua, *text, file.generic_string());
}

void load_module(lua_State* lua, const std::string& name) {
    LuaState& state = LuaState::of(lua);
    if (const auto shipped = shipped_module(name)) {
        state.load_or_raise(lua, *shipped, "scripts/" + relative_file(name));
    } else if (state.module_folder() != nullptr) {
        load_file(lua, *state.module_folder(), name);
    } else {
        raise(lua, fmt::format("no module '{}': this text has no folder", name));
    }
}

} // namespace

void set_module_argument(lua_State* lua, const char* name) {
    push_table(lua, &kArgumentsKey);
    lua_insert(lua, -2);
    lua_setfield(lua, -2, name);
    lua_pop(lua, 1);
}

int require_module(lua_State* lua) {
    std::size_t size = 0;
    const char* const text = luaL_checklstring(lua, 1, &size);
    const std::string name(text, size);
    if (!is_module_name(name)) {
        raise(
            lua,
            fmt::format(
                "'{}' is no module name; expected words with dots between them, like "
                "\"parts.walls\"",
                name));
    }
    push_table(lua, &kModulesKey);
    const int modules = lua_gettop(lua);
    const int known = lua_getfield(lua, modules, name.c_str());
    if (known == LUA_TLIGHTUSERDATA)
        raise(lua, fmt::format("module '{}' requires itself, perhaps through another one", name));
    if (known != LUA_TNIL) return 1;

    lua_pushlightuserdata(lua, nullptr); // under way
    lua_setfield(lua, modules, name.c_str());
    load_module(lua, name);
    push_table(lua, &kArgumentsKey);
    lua_getfield(lua, -1, name.c_str());
    lua_remove(lua, -2);
    lua_call(lua, 1, 1);
    if (lua_isnil(lua, -1))
        raise(lua, fmt::format("module '{}' returns nothing; expected a table", name));
    lua_pushvalue(lua, -1);
    lua_setfield(lua, modules, name.c_str());
    return 1;
}

} // namespace script
