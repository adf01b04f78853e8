// A sandboxed Lua: what scripts may call, how much of the machine they may use, and where they went
// wrong. It links the C++ build of Lua, whose errors are exceptions, so that destructors run.

#pragma once

#include "engine/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct lua_State;
struct lua_Debug;

namespace script {

/// What one call may use. Instructions are the cap that gives the same answer on every machine;
/// seconds catch the long way round through library functions.
struct LuaLimits {
    std::size_t memory_bytes = std::size_t{64} << 20U;
    std::int64_t instructions = 20'000'000;
    double seconds = 5.0; ///< of processor time, so that a busy machine changes nothing
};

/// One Lua with our globals only. Neither movable nor copyable: Lua keeps its address.
///
/// Left out of the language: io, os, debug, package, load, dofile, loadfile, collectgarbage, next,
/// _G, math.randomseed, string.dump, coroutine.close, finalizers and bytecode. `pairs` walks
/// numbers, then strings, then the rest in sorted order; `math.random` starts from the seed;
/// `print` goes to output().
class LuaState {
public:
    /// @param seed of math.random
    explicit LuaState(const LuaLimits& limits = {}, std::int64_t seed = 1);
    LuaState(const LuaState&) = delete;
    LuaState& operator=(const LuaState&) = delete;
    ~LuaState() = default;

    [[nodiscard]] lua_State* lua() const { return state_.get(); }
    /// The owner of any coroutine.
    static LuaState& of(lua_State* lua);

    /// Compiles text and pushes it as a function.
    /// @param name shown in messages, the path as a person would say it
    /// Errors: not Lua; the place is where Lua stopped reading.
    engine::Result<void> load(std::string_view text, const std::string& name);

    /// Calls the function that lies under its arguments, with all limits renewed; leaves its
    /// results. Errors: whatever the script raised, or the limit it passed. A limit cannot be
    /// caught by the script.
    engine::Result<void> call(int argument_count, int result_count);

    /// From now on each call may use these instructions and seconds; the memory cap stays.
    void limit_calls(const LuaLimits& limits);

    /// The stack where the last call failed, a line each; empty when it did not fail.
    [[nodiscard]] const std::string& traceback() const { return traceback_; }

    /// Makes `name` a global of all scripts; takes the value from the top of the stack.
    void set_global(const std::string& name);

    /// Lets `require` find modules: first those shipped with the engine, then files below `folder`.
    void allow_modules(const std::filesystem::path& folder);
    /// Lets `require` find only those shipped with the engine.
    void allow_modules();

    /// Where the function at `level` of the running stack is (1 is the caller of a C function).
    [[nodiscard]] engine::SourcePlace place(lua_State* lua, int level) const;

    /// Text of every chunk loaded so far, by name.
    [[nodiscard]] const std::map<std::string, std::string>& sources() const { return sources_; }
    /// Files that `require` read.
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
    /// What the script printed, a line each; at most 1000 lines.
    [[nodiscard]] const std::vector<std::string>& output() const { return output_; }

    /// The same, and forgets it.
    std::vector<std::string> take_output() { return std::exchange(output_, {}); }

    /// Raises a Lua error when the running call is over its time; for library functions that take
    /// long.
    void check_clock(lua_State* lua);
    /// Compiles text and pushes the function, or raises Lua's own error.
    void load_or_raise(lua_State* lua, std::string_view text, const std::string& name);
    void print(std::string line);
    void add_file(const std::filesystem::path& file) { files_.push_back(file); }
    [[nodiscard]] const std::filesystem::path* module_folder() const {
        return has_folder_ ? &folder_ : nullptr;
    }

private:
    struct Closer {
        void operator()(lua_State* lua) const;
    };

    static void* allocate(void* owner, void* block, std::size_t old_size, std::size_t new_size);
    static void count_hook(lua_State* lua, lua_Debug* activation);
    [[noreturn]] void overrun(lua_State* lua, const std::string& message);
    static int handle_message(lua_State* lua);
    [[nodiscard]] engine::Error error_from(int status) const;
    /// Splits "name:line: message" when `name` is one of ours.
    [[nodiscard]] std::optional<engine::Error> placed_error(std::string_view message) const;

    LuaLimits limits_;
    std::size_t used_bytes_ = 0;
    std::int64_t instructions_left_ = 0;
    double deadline_ = 0.0; ///< seconds of processor time
    engine::Error
        overrun_; ///< the first limit that the running call passed; message empty when none
    std::string traceback_;
    std::map<std::string, std::string> sources_;
    std::map<std::string, std::string, std::less<>>
        chunk_names_; ///< as Lua prints them, to names in sources_
    std::vector<std::filesystem::path> files_;
    std::vector<std::string> output_;
    std::filesystem::path folder_;
    bool has_folder_ = false;
    std::unique_ptr<lua_State, Closer> state_; ///< last: it dies first
};

} // namespace script
