// What a script returned, copied out of Lua: plain values that outlive it and can be walked without
// a stack, a metatable or an error.

#pragma once

#include "engine/core/result.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct lua_State;

namespace script {

struct Table;

struct Value {
    enum class Type { nil, boolean, number, text, table, other };

    Type type = Type::nil;
    bool boolean = false;
    double number = 0.0;
    std::string text; ///< of a text; for other, what Lua calls it ("function")
    std::shared_ptr<const Table> table;

    /// As people write it: 3, "word", true, a table.
    [[nodiscard]] std::string description() const;
};

struct Table {
    std::vector<std::pair<std::string, Value>> fields; ///< with names, sorted
    std::vector<Value> list;         ///< with whole numbers from 1 on, in order; holes left out
    std::vector<std::string> strays; ///< keys of any other type, as people write them
    int constructor = -1; ///< what the script's constructors called it; -1: a plain table
};

/// Caps of a copy.
struct ValueLimits {
    std::size_t values = 300'000; ///< counted each time they are reached
    std::size_t text_bytes = std::size_t{64} << 20U;
    int depth = 32;
};

/// Copies the value at the top of the stack. Runs no script code.
/// @param constructors_key registry key of a table that gives the number of each constructed table
/// Errors: over a limit; a table that contains itself is too deep.
engine::Result<Value>
copy_value(lua_State* lua, const void* constructors_key, const ValueLimits& limits = {});

} // namespace script
