// The subcommands: each adds its options to the command line and, when it was called, runs.

#pragma once

#include <functional>
#include <vector>

#include "tools/gnomon/exit_codes.hpp"

namespace CLI {
class App;
}

namespace gnomon {

/// A subcommand after its options were read. @return an ExitCode
using Run = std::function<int()>;

Run add_render(CLI::App& app);
Run add_measure(CLI::App& app);
Run add_chart(CLI::App& app);
Run add_check(CLI::App& app);
Run add_explain(CLI::App& app);
Run add_play(CLI::App& app);

} // namespace gnomon
