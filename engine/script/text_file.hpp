// Text files that people wrote.

#pragma once

#include "engine/core/result.hpp"

#include <filesystem>
#include <string>

namespace script {

/// The whole file. Errors: no such file, not a file, or larger than 4 MiB; the place is the file.
engine::Result<std::string> read_text_file(const std::filesystem::path& file);

} // namespace script
