#include "engine/script/lua_state.hpp"

#include "engine/core/check.hpp"
#include "engine/script/modules.hpp"
#include "engine/script/sandbox.hpp"

#include <fmt/format.h>
#include <lua.hpp>

#include <cstdlib>
#include <cstring>
#include <ctime>

namespace script {

namespace {

constexpr int kHookInterval = 100; ///< instructions between two looks at the clock and the budget
constexpr std::size_t kMaxOutputLines = 1000;
const char kEnvironmentKey = 0; ///< its address is the key of the chunk environment in the registry

/// Lua cuts longer names in messages (LUA_IDSIZE), so they are cut here, where they can be mapped
/// back.
std::string chunk_name(const std::string& name) {
    constexpr std::size_t kLongest = LUA_IDSIZE - 4;
    std::string cut =
        name.size() <= kLongest ? name : "..." + name.substr(name.size() - kLongest + 3);
    for (char& letter : cut)
        if (static_cast<unsigned char>(letter) < 0x20) letter = '?';
    return cut;
}

/// Time that this thread has worked so far.
double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

} // namespace

void LuaState::Closer::operator()(lua_State* lua) const {
    lua_close(lua);
}

void* LuaState::allocate(void* owner, void* block, std::size_t old_size, std::size_t new_size) {
    auto& self = *static_cast<LuaState*>(owner);
    const std::size_t held =
        block == nullptr ? 0 : old_size; // else old_size tells the kind of object
    if (new_size == 0) {
        std::free(block);
        self.used_bytes_ -= held;
        return nullptr;
    }
    if (new_size > held && new_size - held > self.limits_.memory_bytes - self.used_bytes_)
        return nullptr;
    void* grown = std::realloc(block, new_size);
    if (grown != nullptr) self.used_bytes_ = self.used_bytes_ - held + new_size;
    return grown;
}

LuaState::LuaState(const LuaLimits& limits, std::int64_t seed)
    : limits_(limits),
      state_(lua_newstate(&LuaState::allocate, this)) {
    CHECK(state_ != nullptr);
    lua_State* lua = state_.get();
    LuaState* const self = this;
    std::memcpy(lua_getextraspace(lua), &self, sizeof self);
    lua_pushcfunction(lua, [](lua_State* inner) {
        push_sandbox(inner, luaL_checkinteger(inner, 1));
        lua_rawsetp(inner, LUA_REGISTRYINDEX, &kEnvironmentKey);
        return 0;
    });
    lua_pushinteger(lua, seed);
    CHECK_EQ(lua_pcall(lua, 1, 0, 0), LUA_OK); // the cap is smaller than the libraries themselves
}

LuaState& LuaState::of(lua_State* lua) {
    LuaState* self = nullptr;
    std::memcpy(&self, lua_getextraspace(lua), sizeof self);
    return *self;
}

void LuaState::load_or_raise(lua_State* lua, std::string_view text, const std::string& name) {
    const std::string shown = chunk_name(name);
    sources_[name] = text;
    chunk_names_[shown] = name;
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3); // some editors write a byte order mark
    if (text.starts_with(LUA_SIGNATURE))
        luaL_error(lua, "%s:1: this is bytecode, expected Lua text", shown.c_str());
    if (luaL_loadbufferx(lua, text.data(), text.size(), ("@" + shown).c_str(), "t") != LUA_OK)
        lua_error(lua);
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &kEnvironmentKey);
    lua_setupvalue(lua, -2, 1);
}

engine::Result<void> LuaState::load(std::string_view text, const std::string& name) {
    struct Chunk {
        std::string_view text;
        const std::string& name;
    } chunk{text, name};
    lua_pushcfunction(lua(), [](lua_State* inner) {
        const auto& wanted = *static_cast<const Chunk*>(lua_touserdata(inner, 1));
        of(inner).load_or_raise(inner, wanted.text, wanted.name);
        return 1;
    });
    lua_pushlightuserdata(lua(), &chunk);
    const auto loaded = call(1, 1);
    if (loaded || !loaded.error().place.file.empty()) return loaded;
    return engine::Error{loaded.error().message, {name, 0}};
}

void LuaState::limit_calls(const LuaLimits& limits) {
    limits_.instructions = limits.instructions;
    limits_.seconds = limits.seconds;
}

engine::Result<void> LuaState::call(int argument_count, int result_count) {
    instructions_left_ = limits_.instructions;
    deadline_ = processor_seconds() + limits_.seconds;
    overrun_ = {};
    traceback_.clear();
    lua_sethook(lua(), &LuaState::count_hook, LUA_MASKCOUNT, kHookInterval);

    const int handler = lua_gettop(lua()) - argument_count;
    lua_pushcfunction(lua(), &LuaState::handle_message);
    lua_insert(lua(), handler);
    const int status = lua_pcall(lua(), argument_count, result_count, handler);
    lua_remove(lua(), handler);
    if (status == LUA_OK && overrun_.message.empty()) return {};

    engine::Error error = error_from(status);
    lua_settop(lua(), handler - 1);
    return error;
}

std::optional<engine::Error> LuaState::placed_error(std::string_view message) const {
    for (const auto& [shown, name] : chunk_names_) {
        if (!message.starts_with(shown + ":")) continue;
        const std::string_view rest = message.substr(shown.size() + 1);
        const std::size_t end = rest.find(": ");
        const int line = std::atoi(std::string(rest.substr(0, end)).c_str());
        if (end != std::string_view::npos && line > 0)
            return engine::Error{std::string(rest.substr(end + 2)), {name, line}};
    }
    return std::nullopt;
}

/// Turns whatever was raised into text that starts with a place, if any function of the stack has
/// one.
int LuaState::handle_message(lua_State* lua) {
    luaL_traceback(lua, lua, nullptr, 1);
    of(lua).traceback_ = lua_tostring(lua, -1);
    lua_pop(lua, 1);
    const char* text = lua_type(lua, 1) == LUA_TSTRING ? lua_tostring(lua, 1) : nullptr;
    if (text == nullptr && luaL_callmeta(lua, 1, "__tostring") != 0) text = lua_tostring(lua, -1);
    if (text == nullptr)
        text = lua_pushfstring(
            lua, "the script raised a %s, expected a string", luaL_typename(lua, 1));
    const bool placed = of(lua).placed_error(text).has_value();
    for (int level = 1; !placed; ++level) {
        lua_Debug activation;
        if (lua_getstack(lua, level, &activation) == 0) break;
        lua_getinfo(lua, "Sl", &activation);
        if (activation.currentline <= 0) continue;
        lua_pushfstring(lua, "%s:%d: %s", activation.short_src, activation.currentline, text);
        return 1;
    }
    lua_pushstring(lua, text);
    return 1;
}

engine::Error LuaState::error_from(int status) const {
    if (!overrun_.message.empty()) return overrun_;
    if (status == LUA_ERRMEM)
        return {fmt::format(
            "the script wants more than {} MiB of memory", limits_.memory_bytes >> 20U)};
    const char* raised = lua_type(lua(), -1) == LUA_TSTRING ? lua_tostring(lua(), -1) : nullptr;
    const std::string_view message =
        raised == nullptr ? "the script failed while it failed" : raised;
    return placed_error(message).value_or(engine::Error{std::string(message)});
}

void LuaState::overrun(lua_State* lua, const std::string& message) {
    if (overrun_.message.empty()) overrun_ = {message, place(lua, 0)};
    lua_sethook(
        lua,
        &LuaState::count_hook,
        LUA_MASKCOUNT,
        1); // raises again at each step, so pcall is no way out
    lua_pushstring(lua, overrun_.message.c_str());
    lua_error(lua);
    std::abort(); // lua_error does not return
}

void LuaState::count_hook(lua_State* lua, lua_Debug* /*activation*/) {
    LuaState& self = of(lua);
    self.instructions_left_ -= kHookInterval;
    if (!self.overrun_.message.empty()) self.overrun(lua, {});
    if (self.instructions_left_ <= 0) {
        self.overrun(
            lua,
            fmt::format(
                "the script ran for more than {} instructions; is there an endless loop?",
                self.limits_.instructions));
    }
    self.check_clock(lua);
}

void LuaState::check_clock(lua_State* lua) {
    if (processor_seconds() < deadline_) return;
    overrun(lua, fmt::format("the script ran for more than {} s", limits_.seconds));
}

engine::SourcePlace LuaState::place(lua_State* lua, int level) const {
    for (lua_Debug activation; lua_getstack(lua, level, &activation) != 0; ++level) {
        lua_getinfo(lua, "Sl", &activation);
        const auto found = chunk_names_.find(std::string_view(activation.short_src));
        if (activation.currentline > 0 && found != chunk_names_.end())
            return {found->second, activation.currentline};
    }
    return {};
}

void LuaState::set_global(const std::string& name) {
    push_globals(lua());
    lua_insert(lua(), -2);
    lua_setfield(lua(), -2, name.c_str());
    lua_pop(lua(), 1);
}

void LuaState::print(std::string line) {
    if (output_.size() < kMaxOutputLines) output_.push_back(std::move(line));
}

void LuaState::allow_modules() {
    lua_pushcfunction(lua(), &require_module);
    set_global("require");
}

void LuaState::allow_modules(const std::filesystem::path& folder) {
    folder_ = folder;
    has_folder_ = true;
    allow_modules();
}

} // namespace script
