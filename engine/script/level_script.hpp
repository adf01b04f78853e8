// The Lua of a level, which lives on while the level runs when it has an on_update.

#pragma once

#include "engine/core/result.hpp"
#include "engine/core/schema.hpp"
#include "engine/scene/world.hpp"
#include "engine/script/live_world.hpp"
#include "engine/script/lua_state.hpp"
#include "engine/script/scene_schema.hpp"
#include "engine/script/vocabulary.hpp"

#include <string>
#include <vector>

namespace script {

/// What one on_update may use; memory is capped by the limits of the level. Generous: a thousand
/// things moved take about a tenth of it.
inline constexpr LuaLimits kUpdateLimits = {.instructions = 1'000'000, .seconds = 1.0};

class LevelScript {
public:
    LevelScript(const SceneVocabulary& words, const LuaLimits& limits)
        : schema_(scene_schema(words)),
          state_(limits),
          world_(state_, schema_),
          vocabulary_(state_, schema_, world_) {}
    LevelScript(const LevelScript&) = delete;
    LevelScript& operator=(const LevelScript&) = delete;
    ~LevelScript() = default;

    [[nodiscard]] LuaState& state() { return state_; }
    [[nodiscard]] const engine::Schema& schema() const { return schema_; }
    [[nodiscard]] const Vocabulary& vocabulary() const { return vocabulary_; }

    /// Remembers the on_update of the scene at the top of the stack, which stays.
    /// @return whether there is one
    bool keep_update();

    /// Lets the level act: on_update(dt). Always the same world.
    /// Errors: what went wrong, where, and the traceback; the function is not called again, so
    /// that a mistake is told once.
    engine::Result<void> update(scene::World& world, float dt);

    /// What the script printed since the last call.
    std::vector<std::string> take_output() { return state_.take_output(); }

private:
    engine::Schema schema_;
    LuaState state_;
    LiveWorld world_;
    Vocabulary vocabulary_;
    double time_ = 0.0; ///< seconds since the level began
    bool acts_ = false;
};

} // namespace script
