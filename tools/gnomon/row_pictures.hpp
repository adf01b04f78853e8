// The pictures that a measured row leaves beside its figures.

#pragma once

#include "engine/core/image.hpp"

#include <filesystem>
#include <string>

#include "tools/measure/figures.hpp"
#include "tools/measure/report.hpp"

namespace gnomon {

/// "SCENE_LIGHT_TECHNIQUE", and "_PROTOCOL" behind it when something moves: what the names of a
/// row's pictures begin with. Each part as file_word() writes it.
std::string picture_stem(const measure::Row& row);

/// Green where both agree, red where it is dark but should be lit, blue where it is lit but should
/// be dark; yellow and cyan the same farther from every true edge than the technique's resolution;
/// pixels that no figure uses are grey.
engine::Image error_image(const measure::Comparison& comparison);

/// Writes into `folder`, or nothing where that is empty,
/// - STEM_error.png: see error_image();
/// - STEM_mask.png: the visibility that was measured as 8-bit grey, 255 lit;
/// - STEM_color.png: the lit picture.
/// Of a sequence the row's last frame.
/// Errors: the folder does not exist or the disk is full.
engine::Result<void> write_row_pictures(
    const std::filesystem::path& folder,
    const measure::Row& row,
    const measure::Comparison& comparison,
    const engine::Image& color);

} // namespace gnomon
