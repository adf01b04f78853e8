// Where in a Lua text a field was written. Lua remembers the line of a constructor but not of its
// fields, so they are looked for in the text; what a program computed is not found, and need not
// be.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace script {

/// The line of field `path` ("shadow", "cascades") of the table that constructor `word` got at
/// `line` (1-based).
/// @return the line of the longest part of the path that can be found; `line` itself when nothing
/// is Cost: one walk over the text.
int field_line(
    std::string_view text, int line, std::string_view word, const std::vector<std::string>& path);

} // namespace script
