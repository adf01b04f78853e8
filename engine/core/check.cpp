#include "engine/core/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace engine {

void check_failed(const char* file, int line, const char* expression, const std::string& detail) {
    fmt::print(
        stderr,
        "{}:{}: CHECK({}) failed{}{}\n",
        file,
        line,
        expression,
        detail.empty() ? "" : ": ",
        detail);
    std::fflush(stderr);
    std::abort();
}

} // namespace engine
