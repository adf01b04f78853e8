// The constructors that `require "gnomon"` gives to a level. They build nothing: a table stays the
// table that it is, and the engine remembers what it was called and where.

#pragma once

#include "engine/core/schema.hpp"
#include "engine/script/live_world.hpp"
#include "engine/script/lua_state.hpp"
#include "engine/script/value.hpp"

#include <string>
#include <vector>

namespace script {

/// One call of a constructor.
struct Constructed {
    std::string word; ///< the kind; empty when it was reported as a mistake already
    engine::SourcePlace place;
};

class Vocabulary {
public:
    /// Teaches `state` the constructed kinds of the schema. All must outlive the vocabulary, and
    /// it the scripts.
    Vocabulary(LuaState& state, const engine::Schema& schema, LiveWorld& world);
    Vocabulary(const Vocabulary&) = delete;
    Vocabulary& operator=(const Vocabulary&) = delete;
    ~Vocabulary() = default;

    /// The result of a script, at the top of the stack, as plain values.
    [[nodiscard]] engine::Result<Value> copy_result(const ValueLimits& limits = {}) const;

    /// By Table::constructor.
    [[nodiscard]] const std::vector<Constructed>& constructed() const { return constructed_; }
    /// Unknown words and constructors without a table.
    [[nodiscard]] const std::vector<engine::Error>& mistakes() const { return mistakes_; }

private:
    static int construct(lua_State* lua);
    static int unknown(lua_State* lua);
    void push_constructor(lua_State* lua, const std::string& word);
    void remember(lua_State* lua, const std::string& word, int level);
    [[nodiscard]] bool full() const;

    LuaState& state_;
    const engine::Schema& schema_;
    LiveWorld& world_;
    std::vector<Constructed> constructed_;
    std::vector<engine::Error> mistakes_;
};

} // namespace script
