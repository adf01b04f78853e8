// `g.world`: what a running level sees of the world, and may change in it.

#pragma once

#include "engine/core/result.hpp"
#include "engine/core/schema.hpp"
#include "engine/scene/world.hpp"
#include "engine/script/live_fields.hpp"
#include "engine/script/lua_state.hpp"
#include "engine/script/value.hpp"

#include <functional>
#include <map>
#include <string>

namespace script {

/// Handles that scripts hold are checked against the schema as a level is: a field that does not
/// exist, is not live or gets a wrong value is an error at the script's own line.
class LiveWorld {
public:
    /// Both must outlive this, and this the scripts.
    LiveWorld(LuaState& state, const engine::Schema& schema);
    LiveWorld(const LiveWorld&) = delete;
    LiveWorld& operator=(const LiveWorld&) = delete;
    ~LiveWorld() = default;

    /// Pushes the object that scripts call the world. Call it protected: it allocates.
    void push(lua_State* lua);

    /// Lets scripts see a world for the time of one call.
    /// @param time seconds since the level began
    engine::Result<void>
    during(scene::World& world, double time, const std::function<engine::Result<void>()>& call);

private:
    struct Handle {
        LiveWorld* owner;
        ecs::Entity entity;
    };

    static int read_world(lua_State* lua);
    static int find(lua_State* lua);
    static int read_field(lua_State* lua);
    static int write_field(lua_State* lua);
    static int refuse_write(lua_State* lua);

    scene::World& running(lua_State* lua);
    void push_handle(lua_State* lua, ecs::Entity entity);
    const LiveField& field_of(lua_State* lua, const Handle& handle, const std::string& name);
    [[nodiscard]] std::string title(ecs::Entity entity) const;
    LiveValue checked(lua_State* lua, const Handle& handle, const LiveField& field);

    LuaState& state_;
    const engine::Schema& schema_;
    scene::World* world_ = nullptr; ///< while a call runs
    double time_ = 0.0;
    const scene::World* named_ = nullptr; ///< the world that names_ was made from
    std::map<std::string, ecs::Entity, std::less<>> names_;
};

} // namespace script
