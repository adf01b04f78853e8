// Contracts between programmers: CHECK stays on in release, DCHECK is for hot loops in debug
// builds.
//
// A failed check prints the expression, both values where there are two, and the place, then
// aborts. Anything a person or a machine can get wrong is a Result (result.hpp) instead.

#pragma once

#include <fmt/format.h>

#include <string>

namespace engine {

/// Prints "file:line: CHECK(expression) failed: detail" on standard error and aborts.
[[noreturn]] void
check_failed(const char* file, int line, const char* expression, const std::string& detail);

} // namespace engine

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) ::engine::check_failed(__FILE__, __LINE__, #condition, {});              \
    } while (false)

#define CHECK_OP_(left, op, right)                                                                 \
    do {                                                                                           \
        const auto& check_left = (left);                                                           \
        const auto& check_right = (right);                                                         \
        if (!(check_left op check_right))                                                          \
            ::engine::check_failed(                                                                \
                __FILE__,                                                                          \
                __LINE__,                                                                          \
                #left " " #op " " #right,                                                          \
                fmt::format("{} against {}", check_left, check_right));                            \
    } while (false)

#define CHECK_EQ(left, right) CHECK_OP_(left, ==, right)
#define CHECK_NE(left, right) CHECK_OP_(left, !=, right)
#define CHECK_LT(left, right) CHECK_OP_(left, <, right)
#define CHECK_LE(left, right) CHECK_OP_(left, <=, right)
#define CHECK_GE(left, right) CHECK_OP_(left, >=, right)
#define CHECK_GT(left, right) CHECK_OP_(left, >, right)

#ifdef NDEBUG
#    define DCHECK(condition) static_cast<void>(0)
#else
#    define DCHECK(condition) CHECK(condition)
#endif
