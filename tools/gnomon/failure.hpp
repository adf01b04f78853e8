// How a subcommand ends when it cannot go on.

#pragma once

#include "engine/core/result.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "tools/gnomon/exit_codes.hpp"

namespace gnomon {

/// Prints the sentence on standard error.
inline int fail(const engine::Error& error, ExitCode code) {
    fmt::print(stderr, "gnomon: {}\n", engine::to_string(error));
    return code;
}

} // namespace gnomon
