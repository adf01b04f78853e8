#include "engine/script/live_world.hpp"

#include "engine/core/check.hpp"
#include "engine/core/text.hpp"
#include "engine/script/raise.hpp"
#include "engine/script/report.hpp"
#include "engine/script/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <lua.hpp>

#include <new>
#include <optional>

namespace script {

namespace {

const char kWorldKey = 0;  ///< its address is the key of the metatable of worlds in the registry
const char kHandleKey = 0; ///< the same of handles
const char kPlainKey = 0;  ///< of an empty table: no value that a running level makes is a part

std::string text_at(lua_State* lua, int index) {
    if (lua_type(lua, index) != LUA_TSTRING) return luaL_typename(lua, index);
    std::size_t size = 0;
    const char* text = lua_tolstring(lua, index, &size);
    return {text, size};
}

/// Whether the value at `index` has the metatable under `key`.
bool is_a(lua_State* lua, int index, const void* key) {
    if (lua_type(lua, index) != LUA_TUSERDATA || lua_getmetatable(lua, index) == 0) return false;
    lua_rawgetp(lua, LUA_REGISTRYINDEX, key);
    const bool same = lua_rawequal(lua, -1, -2) != 0;
    lua_pop(lua, 2);
    return same;
}

void make_metatable(
    lua_State* lua, const void* key, LiveWorld* owner, lua_CFunction read, lua_CFunction write) {
    lua_createtable(lua, 0, 3);
    lua_pushlightuserdata(lua, owner);
    lua_pushcclosure(lua, read, 1);
    lua_setfield(lua, -2, "__index");
    lua_pushlightuserdata(lua, owner);
    lua_pushcclosure(lua, write, 1);
    lua_setfield(lua, -2, "__newindex");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_rawsetp(lua, LUA_REGISTRYINDEX, key);
}

LiveWorld& owner_of(lua_State* lua) {
    return *static_cast<LiveWorld*>(lua_touserdata(lua, lua_upvalueindex(1)));
}

void push_value(lua_State* lua, const LiveValue& value) {
    if (const auto* truth = std::get_if<bool>(&value)) {
        lua_pushboolean(lua, *truth ? 1 : 0);
    } else if (const auto* number = std::get_if<double>(&value)) {
        lua_pushnumber(lua, *number);
    } else {
        lua_createtable(lua, 3, 0);
        for (int i = 0; i < 3; ++i) {
            lua_pushnumber(lua, std::get<glm::dvec3>(value)[i]);
            lua_rawseti(lua, -2, i + 1);
        }
    }
}

} // namespace

LiveWorld::LiveWorld(LuaState& state, const engine::Schema& schema)
    : state_(state),
      schema_(schema) {
    lua_pushcfunction(state.lua(), [](lua_State* inner) {
        auto* self = static_cast<LiveWorld*>(lua_touserdata(inner, 1));
        make_metatable(inner, &kWorldKey, self, &LiveWorld::read_world, &LiveWorld::refuse_write);
        make_metatable(inner, &kHandleKey, self, &LiveWorld::read_field, &LiveWorld::write_field);
        lua_newtable(inner);
        lua_rawsetp(inner, LUA_REGISTRYINDEX, &kPlainKey);
        return 0;
    });
    lua_pushlightuserdata(state.lua(), this);
    CHECK(state.call(1, 0).has_value()); // the memory cap is smaller than the metatables
}

void LiveWorld::push(lua_State* lua) {
    lua_newuserdatauv(lua, 0, 0);
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &kWorldKey);
    lua_setmetatable(lua, -2);
}

engine::Result<void> LiveWorld::during(
    scene::World& world, double time, const std::function<engine::Result<void>()>& call) {
    world_ = &world;
    time_ = time;
    engine::Result<void> done = call();
    world_ = nullptr;
    return done;
}

scene::World& LiveWorld::running(lua_State* lua) {
    if (world_ == nullptr)
        raise(lua, "the world is there while the level runs, in on_update, and not before");
    if (named_ != world_) {
        names_.clear();
        world_->registry.each<scene::Name, scene::Transform>(
            [&](ecs::Entity entity, const scene::Name& name, const auto& /*transform*/) {
                names_.emplace(name.text, entity);
            });
        named_ = world_;
    }
    return *world_;
}

void LiveWorld::push_handle(lua_State* lua, ecs::Entity entity) {
    new (lua_newuserdatauv(lua, sizeof(Handle), 0)) Handle{this, entity};
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &kHandleKey);
    lua_setmetatable(lua, -2);
}

std::string LiveWorld::title(ecs::Entity entity) const {
    return fmt::format(
        "{} \"{}\"", live_kind(*world_, entity), world_->registry.get<scene::Name>(entity).text);
}

int LiveWorld::read_world(lua_State* lua) {
    LiveWorld& self = owner_of(lua);
    const std::string word = text_at(lua, 2);
    if (word == "find") {
        lua_pushlightuserdata(lua, &self);
        lua_pushcclosure(lua, &LiveWorld::find, 1);
        return 1;
    }
    if (word != "time") raise(lua, fmt::format("the world has no '{}'; it has find, time", word));
    self.running(lua);
    lua_pushnumber(lua, self.time_);
    return 1;
}

int LiveWorld::refuse_write(lua_State* lua) {
    raise(lua, fmt::format("'{}' of the world cannot be set", text_at(lua, 2)));
}

int LiveWorld::find(lua_State* lua) {
    LiveWorld& self = owner_of(lua);
    if (!is_a(lua, 1, &kWorldKey) || lua_type(lua, 2) != LUA_TSTRING)
        raise(lua, "find wants a name; write: world:find(\"name\")");
    self.running(lua);
    const std::string name = text_at(lua, 2);
    const auto found = self.names_.find(name);
    if (found == self.names_.end()) {
        std::vector<std::string_view> names;
        for (const auto& [known, entity] : self.names_)
            names.emplace_back(known);
        raise(
            lua,
            fmt::format(
                "nothing is called \"{}\" in this level{}",
                name,
                engine::did_you_mean(name, names)));
    }
    self.push_handle(lua, found->second);
    return 1;
}

const LiveField&
LiveWorld::field_of(lua_State* lua, const Handle& handle, const std::string& name) {
    const std::string_view kind = live_kind(running(lua), handle.entity);
    std::vector<std::string_view> names;
    for (const LiveField& field : live_fields()) {
        if (field.kind != kind) continue;
        if (field.field == name) return field;
        names.push_back(field.field);
    }
    std::string hint = engine::did_you_mean(name, names);
    if (hint.empty()) hint = fmt::format("; it has {}", fmt::join(names, ", "));
    raise(
        lua,
        fmt::format("{} has no '{}' while the level runs{}", title(handle.entity), name, hint));
}

int LiveWorld::read_field(lua_State* lua) {
    const auto& handle = *static_cast<const Handle*>(lua_touserdata(lua, 1));
    LiveWorld& self = *handle.owner;
    const std::string name = text_at(lua, 2);
    const scene::World& world = self.running(lua);
    if (name == "name") {
        const std::string& text = world.registry.get<scene::Name>(handle.entity).text;
        lua_pushlstring(lua, text.data(), text.size());
        return 1;
    }
    push_value(lua, self.field_of(lua, handle, name).read(world, handle.entity));
    return 1;
}

/// The value at the top of the stack, if the schema allows it.
LiveValue LiveWorld::checked(lua_State* lua, const Handle& handle, const LiveField& field) {
    const auto value = copy_value(lua, &kPlainKey, {.values = 64, .text_bytes = 1024, .depth = 2});
    if (!value) raise(lua, value.error().message);
    Table table;
    table.fields.emplace_back(std::string(field.field), *value);
    Report report(state_.sources());
    TableReader reader(table, schema_, field.kind, report, {title(handle.entity), {}, {}, {}});
    LiveValue result;
    switch (schema_.kind(field.kind).find(field.field)->type) {
    case engine::FieldType::boolean:
        result = reader.boolean(field.field);
        break;
    case engine::FieldType::number:
        result = reader.number(field.field);
        break;
    default:
        result = reader.vector(field.field);
        if (field.field == "direction" && glm::length(std::get<glm::dvec3>(result)) < 1e-9)
            reader.complain(field.field, "has no length");
    }
    const auto errors = report.errors();
    if (!errors.empty()) raise(lua, errors.front().message);
    return result;
}

int LiveWorld::write_field(lua_State* lua) {
    const auto& handle = *static_cast<const Handle*>(lua_touserdata(lua, 1));
    LiveWorld& self = *handle.owner;
    const LiveField& field = self.field_of(lua, handle, text_at(lua, 2));
    const LiveValue value = self.checked(lua, handle, field);
    if (field.read(*self.world_, handle.entity) != value)
        field.write(*self.world_, handle.entity, value);
    return 0;
}

} // namespace script
