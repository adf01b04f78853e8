#include "engine/script/value.hpp"

#include "engine/core/schema.hpp"

#include <fmt/format.h>
#include <lua.hpp>

#include <algorithm>
#include <optional>

namespace script {

namespace {

class Copier {
public:
    Copier(lua_State* lua, const void* constructors_key, const ValueLimits& limits)
        : lua_(lua),
          constructors_key_(constructors_key),
          left_(limits) {}

    /// The value at the top, which stays.
    Value copy(int depth) {
        Value value;
        if (left_.values == 0) stop("the script returned too many values");
        if (stopped_) return value;
        --left_.values;
        switch (lua_type(lua_, -1)) {
        case LUA_TNIL:
            break;
        case LUA_TBOOLEAN:
            value.type = Value::Type::boolean;
            value.boolean = lua_toboolean(lua_, -1) != 0;
            break;
        case LUA_TNUMBER:
            value.type = Value::Type::number;
            value.number = lua_tonumber(lua_, -1);
            break;
        case LUA_TSTRING:
            value.type = Value::Type::text;
            value.text = text_at(-1);
            break;
        case LUA_TTABLE:
            value.type = Value::Type::table;
            value.table = copy_table(depth);
            break;
        default:
            value.type = Value::Type::other;
            value.text = luaL_typename(lua_, -1);
        }
        return value;
    }

    [[nodiscard]] const std::optional<std::string>& stopped() const { return stopped_; }

private:
    void stop(const char* why) {
        if (!stopped_) stopped_ = why;
    }

    std::string text_at(int index) {
        std::size_t size = 0;
        const char* text = lua_tolstring(lua_, index, &size);
        if (size > left_.text_bytes) {
            stop("the script returned too much text");
            return {};
        }
        left_.text_bytes -= size;
        return {text, size};
    }

    std::shared_ptr<const Table> copy_table(int depth) {
        auto table = std::make_shared<Table>();
        if (depth == 0 || lua_checkstack(lua_, 8) == 0) {
            stop("the tables that the script returned are nested too deep, or contain themselves");
            return table;
        }
        lua_rawgetp(lua_, LUA_REGISTRYINDEX, constructors_key_);
        lua_pushvalue(lua_, -2);
        if (lua_rawget(lua_, -2) == LUA_TNUMBER)
            table->constructor = static_cast<int>(lua_tointeger(lua_, -1));
        lua_pop(lua_, 2);

        std::vector<std::pair<lua_Integer, Value>> list;
        for (lua_pushnil(lua_); lua_next(lua_, -2) != 0; lua_pop(lua_, 1)) {
            if (lua_type(lua_, -2) == LUA_TSTRING) {
                std::string key = text_at(-2);
                table->fields.emplace_back(std::move(key), copy(depth - 1));
            } else if (lua_isinteger(lua_, -2) != 0 && lua_tointeger(lua_, -2) > 0) {
                const lua_Integer key = lua_tointeger(lua_, -2);
                list.emplace_back(key, copy(depth - 1));
            } else {
                table->strays.push_back(stray_key());
            }
        }
        std::sort(
            table->fields.begin(), table->fields.end(), [](const auto& left, const auto& right) {
                return left.first < right.first;
            });
        std::sort(table->strays.begin(), table->strays.end());
        std::sort(list.begin(), list.end(), [](const auto& left, const auto& right) {
            return left.first < right.first;
        });
        for (auto& [key, value] : list)
            table->list.push_back(std::move(value));
        return table;
    }

    std::string stray_key() {
        if (lua_type(lua_, -2) == LUA_TNUMBER) return engine::shortest(lua_tonumber(lua_, -2));
        if (lua_type(lua_, -2) == LUA_TBOOLEAN)
            return lua_toboolean(lua_, -2) != 0 ? "true" : "false";
        return luaL_typename(lua_, -2);
    }

    lua_State* lua_;
    const void* constructors_key_;
    ValueLimits left_;
    std::optional<std::string> stopped_;
};

} // namespace

std::string Value::description() const {
    constexpr std::size_t kLongestShown = 60;
    switch (type) {
    case Type::nil:
        return "nil";
    case Type::boolean:
        return boolean ? "true" : "false";
    case Type::number:
        return engine::shortest(number);
    case Type::text:
        return text.size() <= kLongestShown
                   ? fmt::format("\"{}\"", text)
                   : fmt::format("\"{}...\"", text.substr(0, kLongestShown));
    case Type::table:
        return "a table";
    case Type::other:
        return "a " + text;
    }
    return {};
}

engine::Result<Value>
copy_value(lua_State* lua, const void* constructors_key, const ValueLimits& limits) {
    Copier copier(lua, constructors_key, limits);
    Value value = copier.copy(limits.depth);
    if (copier.stopped()) return engine::Error{*copier.stopped()};
    return value;
}

} // namespace script
