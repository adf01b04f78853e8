// What happens when a program misuses the registry: one sentence on standard error, then abort.

#pragma once

#include "ecs/entity.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>
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
    std::string sentence = "ecs: entity " + std::to_string(entity.index());
    sentence += " (generation " + std::to_string(entity.generation()) + ") ";
    sentence.append(what).append(type).append("\n");
    std::fputs(sentence.c_str(), stderr);
    std::abort();
}

} // namespace ecs
