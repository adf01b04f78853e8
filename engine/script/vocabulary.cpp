#include "engine/script/vocabulary.hpp"

#include "engine/core/check.hpp"
#include "engine/core/text.hpp"
#include "engine/script/modules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <lua.hpp>

namespace script {

namespace {

const char kConstructedKey =
    0; ///< its address is the key of the table from constructed tables to their numbers
constexpr std::size_t kMaxConstructed = 200'000;
constexpr std::size_t kMaxMistakes = 100;

/// `example` in messages: what a call looks like.
std::string call_of(const std::string& word) {
    return fmt::format("g.{} {{ ... }}", word);
}

} // namespace

Vocabulary::Vocabulary(LuaState& state, const engine::Schema& schema, LiveWorld& world)
    : state_(state),
      schema_(schema),
      world_(world) {
    lua_State* lua = state.lua();
    lua_pushcfunction(lua, [](lua_State* inner) {
        auto& self = *static_cast<Vocabulary*>(lua_touserdata(inner, 1));
        lua_newtable(inner);
        lua_rawsetp(inner, LUA_REGISTRYINDEX, &kConstructedKey);
        lua_createtable(inner, 0, 3);
        lua_newtable(inner);
        for (const engine::Kind& kind : self.schema_.kinds) {
            if (!kind.constructed) continue;
            self.push_constructor(inner, kind.name);
            lua_setfield(inner, -2, kind.name.c_str());
        }
        lua_setfield(inner, -2, "constructors");
        lua_pushlightuserdata(inner, &self);
        lua_pushcclosure(inner, &Vocabulary::unknown, 1);
        lua_setfield(inner, -2, "unknown");
        self.world_.push(inner);
        lua_setfield(inner, -2, "world");
        set_module_argument(inner, "gnomon");
        return 0;
    });
    lua_pushlightuserdata(lua, this);
    CHECK(state.call(1, 0).has_value()); // the memory cap is smaller than the constructors
}

engine::Result<Value> Vocabulary::copy_result(const ValueLimits& limits) const {
    return copy_value(state_.lua(), &kConstructedKey, limits);
}

void Vocabulary::push_constructor(lua_State* lua, const std::string& word) {
    lua_pushlightuserdata(lua, this);
    lua_pushlstring(lua, word.data(), word.size());
    lua_pushcclosure(lua, &Vocabulary::construct, 2);
}

/// Numbers the table at the top of the stack.
void Vocabulary::remember(lua_State* lua, const std::string& word, int level) {
    if (constructed_.size() >= kMaxConstructed)
        luaL_error(lua, "a level may have at most %d parts", static_cast<int>(kMaxConstructed));
    constructed_.push_back({word, state_.place(lua, level)});
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &kConstructedKey);
    lua_pushvalue(lua, -2);
    lua_pushinteger(lua, static_cast<lua_Integer>(constructed_.size()) - 1);
    lua_rawset(lua, -3);
    lua_pop(lua, 1);
}

bool Vocabulary::full() const {
    return mistakes_.size() >= kMaxMistakes;
}

int Vocabulary::construct(lua_State* lua) {
    auto& self = *static_cast<Vocabulary*>(lua_touserdata(lua, lua_upvalueindex(1)));
    std::string word = lua_tostring(lua, lua_upvalueindex(2));
    lua_settop(lua, 1);
    if (lua_type(lua, 1) != LUA_TTABLE) {
        if (!word.empty() && !self.full()) {
            self.mistakes_.push_back(
                {fmt::format(
                     "{} is called with a {}, expected a table: {}",
                     word,
                     luaL_typename(lua, 1),
                     call_of(word)),
                 self.state_.place(lua, 1)});
        }
        word.clear();
        lua_newtable(lua);
    }
    self.remember(lua, word, 1);
    return 1;
}

/// Called for g.word when there is no such word: reports it and goes on, so that other mistakes are
/// found too.
int Vocabulary::unknown(lua_State* lua) {
    auto& self = *static_cast<Vocabulary*>(lua_touserdata(lua, lua_upvalueindex(1)));
    std::size_t size = 0;
    const char* text = lua_type(lua, 1) == LUA_TSTRING ? lua_tolstring(lua, 1, &size) : nullptr;
    const std::string word = text == nullptr ? luaL_typename(lua, 1) : std::string(text, size);
    std::vector<std::string_view> words = {"srgb", "world"};
    for (const engine::Kind& kind : self.schema_.kinds)
        if (kind.constructed) words.emplace_back(kind.name);
    if (!self.full()) {
        std::string hint = engine::did_you_mean(word, words);
        if (hint.empty()) hint = fmt::format("; the words are {}", fmt::join(words, ", "));
        self.mistakes_.push_back(
            {fmt::format("'{}' is no word of gnomon{}", word, hint), self.state_.place(lua, 2)});
    }
    self.push_constructor(lua, "");
    return 1;
}

} // namespace script
