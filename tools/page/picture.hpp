// Pictures as pages carry them: small.

#pragma once

#include "engine/core/image.hpp"

#include <string>

namespace page {

/// A picture no wider than that, each pixel the mean of the area that it covers; a narrower one as
/// it is. The height follows. @pre width_px at least 1
engine::Image at_most_wide(const engine::Image& image, int width_px);

/// As a PNG file: nothing is lost. For pictures of few colours.
std::string png_url(const engine::Image& image);

/// As a JPEG file. @param quality 1 to 100. @pre 1 or 3 channels
std::string jpeg_url(const engine::Image& image, int quality = 80);

} // namespace page
