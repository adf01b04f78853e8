// A truth on disk: pictures for people, numbers for programs.

#pragma once

#include "engine/core/image.hpp"
#include "engine/core/result.hpp"

#include <filesystem>
#include <string>

#include "tools/truth/truth.hpp"

namespace truth {

/// Visibility as 8-bit grey, 255 lit; 255 where nothing is hit.
engine::Image mask_picture(const TruthImage& truth);

/// Writes into `folder`
/// - truth_NAME.png: mask_picture();
/// - truth_NAME_valid.png: 255 where the truth is sure, 64 where it is undecided, 0 where nothing
/// is hit;
/// - truth_NAME.json: the size and the shares.
/// Errors: the folder does not exist or the disk is full.
engine::Result<void>
write_truth(const std::filesystem::path& folder, const std::string& name, const TruthImage& truth);

} // namespace truth
