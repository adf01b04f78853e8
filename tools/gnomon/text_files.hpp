// Folders and text files that subcommands leave behind.

#pragma once

#include "engine/core/result.hpp"

#include <filesystem>
#include <string>

namespace gnomon {

/// With everything above it. Errors: it cannot be made.
engine::Result<void> make_folder(const std::filesystem::path& folder);

/// Errors: the folder does not exist or the disk is full.
engine::Result<void> write_text(const std::filesystem::path& file, const std::string& text);

/// Part of a file name: letters, digits, '-', '.' stay, everything else becomes '_'.
std::string file_word(const std::string& name);

} // namespace gnomon
