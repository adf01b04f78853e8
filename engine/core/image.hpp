// Pictures in memory and as PNG files: 8 bits a channel, top row first.

#pragma once

#include "engine/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace engine {

/// 8-bit pixels, row by row from the top, channels interleaved.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0; ///< 1 grey, 3 RGB, 4 RGBA
    std::vector<std::uint8_t> bytes;

    Image() = default;
    Image(int width_px, int height_px, int channel_count)
        : width(width_px),
          height(height_px),
          channels(channel_count),
          bytes(
              static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)
              * static_cast<std::size_t>(channel_count)) {}

    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// The channels of pixel (x, y), y down from the top.
    [[nodiscard]] std::uint8_t* at(int x, int y) { return bytes.data() + index(x, y); }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const { return bytes.data() + index(x, y); }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                + static_cast<std::size_t>(x))
               * static_cast<std::size_t>(channels);
    }
};

/// Errors: the folder does not exist or the disk is full.
Result<void> write_png(const std::filesystem::path& file, const Image& image);

/// The bytes of a PNG file.
std::vector<std::uint8_t> encode_png(const Image& image);

/// The bytes of a JPEG file. @param quality 1 to 100. @pre 1 or 3 channels
std::vector<std::uint8_t> encode_jpeg(const Image& image, int quality);

/// @param channels 1, 3 or 4 to convert, 0 to keep what the file has
/// Errors: no such file, or not a picture.
Result<Image> read_png(const std::filesystem::path& file, int channels = 0);

} // namespace engine
