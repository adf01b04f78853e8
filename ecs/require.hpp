// What happens when a program misuses the registry: one sentence on standard error, then abort.

#pragma once

#include "ecs/entity.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace ecs {

/// "scene::Transform" for T = scene::Transform, as the compiler spells it.
template <class T>
constexpr std::string_view component_name() {
    constexpr std::string_view kFunction = __PRETTY_FUNCTION__;
    constexpr std::size_t kFirst = kFunction.find("T = ") + 4;
    return kFunction.substr(kFirst, kFunction.find_first_of(";]", kFirst) - kFirst);
}

/// Prints "ecs: entity 7 (generation 2) is not alive" or "... has no scene::Transform" and aborts.
[[noreturn]] inline void misuse(Entity entity, std::string_view what, std::string_view type = "") {
    std::fprintf(
        stderr,
        "ecs: entity %u (generation %u) %.*s%.*s\n",
        entity.index(),
        entity.generation(),
        static_cast<int>(what.size()),
        what.data(),
        static_cast<int>(type.size()),
        type.data());
    std::abort();
}

} // namespace ecs
