#include "engine/script/guarded_library.hpp"

#include "engine/script/lua_state.hpp"

#include <fmt/format.h>
#include <lua.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace script {

namespace {

/// Steps that one call of a library function may take: about a second.
constexpr double kMaxSteps = 1e9;

int call_original(lua_State* lua) {
    LuaState::of(lua).check_clock(lua);
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

/// Parts of a pattern that can match at many lengths.
int repetitions(std::string_view pattern) {
    int count = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool escape = pattern[i] == '%' && i + 1 < pattern.size();
        if (escape) ++i;
        const std::string_view repeated = escape ? "b123456789" : "*+-?";
        if (repeated.find(pattern[i]) != std::string_view::npos) ++count;
    }
    return count;
}

/// The most steps a search for `pattern` in `size` bytes can take: with q repetitions, every way to
/// choose a start and q ends in order, each compared with the whole pattern.
double search_steps(double size, std::string_view pattern) {
    const double choices = repetitions(pattern) + 1.0;
    double ways = 1.0;
    for (double chosen = 1.0; chosen <= choices && ways < kMaxSteps; ++chosen)
        ways *= (size + chosen) / chosen;
    return ways * static_cast<double>(pattern.size() + 1);
}

/// find, match, gmatch, gsub: subject, pattern.
int search(lua_State* lua) {
    std::size_t size = 0;
    std::size_t pattern_size = 0;
    luaL_checklstring(lua, 1, &size);
    const char* pattern = luaL_checklstring(lua, 2, &pattern_size);
    if (search_steps(static_cast<double>(size), {pattern, pattern_size}) > kMaxSteps)
        return luaL_error(
            lua, "this pattern could take hours on a text of %d bytes", static_cast<int>(size));
    return call_original(lua);
}

int repeat(lua_State* lua) {
    constexpr lua_Integer kMostCopies = 1 << 26;
    if (luaL_checkinteger(lua, 2) > kMostCopies)
        return luaL_error(lua, "more than %d copies of a string", static_cast<int>(kMostCopies));
    return call_original(lua);
}

/// Functions whose first argument is a table walk all that its length promises, so the length must
/// be real.
int with_plain_table(lua_State* lua) {
    if (lua_type(lua, 1) == LUA_TTABLE && lua_getmetatable(lua, 1) != 0)
        return luaL_error(lua, "functions of 'table' want a table without a metatable");
    return call_original(lua);
}

int move(lua_State* lua) {
    constexpr double kMostElements = 1 << 24;
    const auto first = static_cast<double>(luaL_checkinteger(lua, 2));
    const auto last = static_cast<double>(luaL_checkinteger(lua, 3));
    if (last - first >= kMostElements) return luaL_error(lua, "too many elements to move");
    if (lua_gettop(lua) >= 5 && lua_type(lua, 5) == LUA_TTABLE && lua_getmetatable(lua, 5) != 0)
        return luaL_error(lua, "functions of 'table' want a table without a metatable");
    return with_plain_table(lua);
}

int set_metatable(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    if (lua_type(lua, 2) == LUA_TTABLE) {
        lua_pushliteral(lua, "__gc");
        if (lua_rawget(lua, 2) != LUA_TNIL)
            return luaL_error(lua, "finalizers (__gc) are left out of the Lua that levels see");
        lua_pop(lua, 1);
    }
    return call_original(lua);
}

/// Without addresses: they differ from run to run.
int to_string(lua_State* lua) {
    luaL_checkany(lua, 1);
    const int type = lua_type(lua, 1);
    const bool has_address = type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TTHREAD;
    if (has_address && luaL_getmetafield(lua, 1, "__tostring") == LUA_TNIL) {
        lua_pushstring(lua, luaL_typename(lua, 1));
        return 1;
    }
    luaL_tolstring(lua, 1, nullptr);
    return 1;
}

/// "%s" of a table would show its address, and so would "%p".
int format(lua_State* lua) {
    const std::string_view form = luaL_checkstring(lua, 1);
    for (std::size_t i = 0; i + 1 < form.size(); ++i) {
        if (form[i] != '%') continue;
        i = std::min(form.find_first_not_of("-+ #0123456789.", i + 1), form.size() - 1);
        if (form[i] == 'p') return luaL_error(lua, "addresses (%%p) differ from run to run");
    }
    for (int i = lua_gettop(lua); i > 1; --i) {
        if (lua_type(lua, i) != LUA_TTABLE && lua_type(lua, i) != LUA_TFUNCTION) continue;
        lua_pushcfunction(lua, &to_string);
        lua_pushvalue(lua, i);
        lua_call(lua, 1, 1);
        lua_replace(lua, i);
    }
    return call_original(lua);
}

int print(lua_State* lua) {
    const int count = lua_gettop(lua);
    std::string line;
    for (int i = 1; i <= count; ++i) {
        lua_pushcfunction(lua, &to_string);
        lua_pushvalue(lua, i);
        lua_call(lua, 1, 1);
        std::size_t size = 0;
        const char* text = lua_tolstring(lua, -1, &size);
        constexpr std::size_t kLongestLine = 1000;
        if (i > 1) line += '\t';
        line.append(text, std::min(size, kLongestLine));
        lua_pop(lua, 1);
    }
    LuaState::of(lua).print(std::move(line));
    return 0;
}

/// Numbers by value, then strings by bytes, then booleans; anything else has no order of its own
/// and stays behind.
bool key_less(lua_State* lua, int keys, lua_Integer left, lua_Integer right) {
    lua_rawgeti(lua, keys, left);
    lua_rawgeti(lua, keys, right);
    const auto rank = [&](int index) {
        switch (lua_type(lua, index)) {
        case LUA_TNUMBER:
            return 0;
        case LUA_TSTRING:
            return 1;
        case LUA_TBOOLEAN:
            return 2;
        default:
            return 3;
        }
    };
    bool less = rank(-2) < rank(-1);
    if (rank(-2) == rank(-1)) {
        if (rank(-1) <= 1) less = lua_compare(lua, -2, -1, LUA_OPLT) != 0;
        if (rank(-1) == 2) less = lua_toboolean(lua, -2) < lua_toboolean(lua, -1);
    }
    lua_pop(lua, 2);
    return less;
}

/// Pushes the keys of the table at `index` in order, as a list.
void push_sorted_keys(lua_State* lua, int index) {
    lua_newtable(lua);
    const int keys = lua_gettop(lua);
    lua_Integer count = 0;
    for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
        lua_pushvalue(lua, -2);
        lua_rawseti(lua, keys, ++count);
    }
    std::vector<lua_Integer> order(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<lua_Integer>(i) + 1;
    std::stable_sort(order.begin(), order.end(), [&](lua_Integer left, lua_Integer right) {
        return key_less(lua, keys, left, right);
    });
    lua_createtable(lua, static_cast<int>(count), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        lua_rawgeti(lua, keys, order[i]);
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_remove(lua, keys);
}

/// Iterator of pairs: upvalues are the table, its sorted keys and how many were given.
int next_pair(lua_State* lua) {
    lua_Integer position = lua_tointeger(lua, lua_upvalueindex(3));
    while (true) {
        lua_pushinteger(lua, ++position);
        lua_replace(lua, lua_upvalueindex(3));
        if (lua_rawgeti(lua, lua_upvalueindex(2), position) == LUA_TNIL) return 1;
        lua_pushvalue(lua, -1);
        if (lua_rawget(lua, lua_upvalueindex(1)) != LUA_TNIL) return 2;
        lua_pop(lua, 2); // taken out since the walk began
    }
}

int pairs(lua_State* lua) {
    if (luaL_getmetafield(lua, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(lua, 1);
        lua_call(lua, 1, 3);
        return 3;
    }
    luaL_checktype(lua, 1, LUA_TTABLE);
    LuaState::of(lua).check_clock(lua);
    lua_pushvalue(lua, 1);
    push_sorted_keys(lua, 1);
    lua_pushinteger(lua, 0);
    lua_pushcclosure(lua, &next_pair, 3);
    lua_pushvalue(lua, 1);
    lua_pushnil(lua);
    return 3;
}

/// Errors from a hook reach a message handler while hooks are off, so a handler that loops would
/// never be stopped. Here it is called after the stack is unwound. Cannot be yielded across.
int protected_call(lua_State* lua) {
    luaL_checktype(lua, 2, LUA_TFUNCTION);
    const int argument_count = lua_gettop(lua) - 2;
    lua_pushvalue(lua, 1);
    lua_insert(lua, 3);
    if (lua_pcall(lua, argument_count, LUA_MULTRET, 0) == LUA_OK) {
        lua_pushboolean(lua, 1);
        lua_replace(lua, 2);
        return lua_gettop(lua) - 1;
    }
    lua_pushvalue(lua, 2);
    lua_insert(lua, -2);
    lua_pcall(lua, 1, 1, 0);
    lua_pushboolean(lua, 0);
    lua_insert(lua, -2);
    return 2;
}

/// One step of a wrapped coroutine. Lua's own closes a coroutine that failed, and so runs __close
/// functions while hooks are off; this one leaves it to the collector.
int resume_wrapped(lua_State* lua) {
    lua_State* coroutine = lua_tothread(lua, lua_upvalueindex(1));
    const int argument_count = lua_gettop(lua);
    if (lua_checkstack(coroutine, argument_count) == 0)
        return luaL_error(lua, "too many arguments to resume");
    lua_xmove(lua, coroutine, argument_count);
    int result_count = 0;
    const int status = lua_resume(coroutine, lua, argument_count, &result_count);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_xmove(coroutine, lua, 1);
        return lua_error(lua);
    }
    luaL_checkstack(lua, result_count, "too many results");
    lua_xmove(coroutine, lua, result_count);
    return result_count;
}

int wrap(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TFUNCTION);
    lua_State* coroutine = lua_newthread(lua);
    lua_pushvalue(lua, 1);
    lua_xmove(lua, coroutine, 1);
    lua_pushcclosure(lua, &resume_wrapped, 1);
    return 1;
}

struct Replacement {
    std::string_view library;
    const char* name;
    lua_CFunction function; ///< sees the original as its upvalue
};

constexpr std::array kReplacements = {
    Replacement{"", "pairs", &pairs},
    Replacement{"", "print", &print},
    Replacement{"", "setmetatable", &set_metatable},
    Replacement{"", "tostring", &to_string},
    Replacement{"", "xpcall", &protected_call},
    Replacement{"coroutine", "wrap", &wrap},
    Replacement{"string", "find", &search},
    Replacement{"string", "format", &format},
    Replacement{"string", "gmatch", &search},
    Replacement{"string", "gsub", &search},
    Replacement{"string", "match", &search},
    Replacement{"string", "rep", &repeat},
    Replacement{"table", "concat", &with_plain_table},
    Replacement{"table", "insert", &with_plain_table},
    Replacement{"table", "move", &move},
    Replacement{"table", "remove", &with_plain_table},
    Replacement{"table", "sort", &with_plain_table},
    Replacement{"table", "unpack", &with_plain_table}};

} // namespace

void guard_library(lua_State* lua, std::string_view library) {
    for (const Replacement& replacement : kReplacements) {
        if (replacement.library != library) continue;
        lua_getfield(lua, -1, replacement.name);
        lua_pushcclosure(lua, replacement.function, 1);
        lua_setfield(lua, -2, replacement.name);
    }
}

} // namespace script
