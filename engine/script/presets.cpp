#include "engine/script/presets.hpp"

#include "engine/script/modules.hpp"

#include <lua.hpp>

#include <algorithm>

namespace script {

namespace {

const Value* find(const Value& value, const std::string& name) {
    if (value.type != Value::Type::table) return nullptr;
    for (const auto& [field, held] : value.table->fields)
        if (field == name) return &held;
    return nullptr;
}

/// The fields of both, tables inside tables alike; `own` wins.
Value merged(const Value& own, const Value& from) {
    if (own.type != Value::Type::table || from.type != Value::Type::table) return own;
    auto table = std::make_shared<Table>(*own.table);
    for (const auto& [name, value] : from.table->fields) {
        const auto at = std::lower_bound(
            table->fields.begin(),
            table->fields.end(),
            name,
            [](const auto& field, const auto& wanted) { return field.first < wanted; });
        if (at != table->fields.end() && at->first == name) {
            at->second = merged(at->second, value);
        } else {
            table->fields.emplace(at, name, value);
        }
    }
    Value result = own;
    result.table = std::move(table);
    return result;
}

} // namespace

engine::Result<Value>
filled_by_preset(const Value& scene, LuaState& state, const Vocabulary& vocabulary) {
    const Value* wanted = find(scene, "preset");
    if (wanted == nullptr || wanted->type != Value::Type::text) return scene;
    lua_State* lua = state.lua();
    lua_pushcfunction(lua, [](lua_State* inner) {
        lua_pushliteral(inner, "gnomon.presets");
        return require_module(inner);
    });
    if (const auto done = state.call(0, 1); !done) return done.error();
    const auto presets = vocabulary.copy_result();
    lua_pop(lua, 1);
    if (!presets) return presets.error();
    const Value* preset = find(*presets, wanted->text);
    return preset == nullptr ? scene : merged(scene, *preset);
}

} // namespace script
