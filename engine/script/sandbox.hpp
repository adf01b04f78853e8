// The globals that scripts see. Functions that could hang inside C, where no hook reaches, check
// what they are asked first.

#pragma once

#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace script {

/// A global of the sandbox: a function of the base library, or a table of functions.
struct SandboxName {
    std::string_view name;
    std::vector<std::string_view> members; ///< empty for a plain function
};

/// What every script may call, besides what set_global() adds.
const std::vector<SandboxName>& sandbox_names();

/// Makes the globals, and pushes the environment of chunks: a view of them in which unknown names
/// and assignments are errors. Call it protected: it allocates.
/// @param seed of math.random
void push_sandbox(lua_State* lua, long long seed);

/// Pushes the table of globals that the environment shows.
void push_globals(lua_State* lua);

} // namespace script
