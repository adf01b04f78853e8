#include "engine/core/image.hpp"

#include "engine/core/check.hpp"

#include <fmt/format.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <memory>

namespace engine {

namespace {

/// For stb's writers: adds bytes to the vector that `context` is.
void append_bytes(void* context, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    auto& whole = *static_cast<std::vector<std::uint8_t>*>(context);
    whole.insert(whole.end(), bytes, bytes + size);
}

} // namespace

Result<void> write_png(const std::filesystem::path& file, const Image& image) {
    CHECK_EQ(image.bytes.size(), image.pixel_count() * static_cast<std::size_t>(image.channels));
    const int stride = image.width * image.channels;
    if (stbi_write_png(
            file.c_str(), image.width, image.height, image.channels, image.bytes.data(), stride)
        == 0)
        return Error{
            "could not be written; expected a folder that exists and has room", {file.string()}};
    return {};
}

std::vector<std::uint8_t> encode_png(const Image& image) {
    CHECK_EQ(image.bytes.size(), image.pixel_count() * static_cast<std::size_t>(image.channels));
    std::vector<std::uint8_t> file;
    CHECK(
        stbi_write_png_to_func(
            append_bytes,
            &file,
            image.width,
            image.height,
            image.channels,
            image.bytes.data(),
            image.width * image.channels)
        != 0);
    return file;
}

std::vector<std::uint8_t> encode_jpeg(const Image& image, int quality) {
    CHECK_EQ(image.bytes.size(), image.pixel_count() * static_cast<std::size_t>(image.channels));
    CHECK(image.channels == 1 || image.channels == 3);
    std::vector<std::uint8_t> file;
    CHECK(
        stbi_write_jpg_to_func(
            append_bytes,
            &file,
            image.width,
            image.height,
            image.channels,
            image.bytes.data(),
            quality)
        != 0);
    return file;
}

Result<Image> read_png(const std::filesystem::path& file, int channels) {
    int width = 0;
    int height = 0;
    int found = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load(file.c_str(), &width, &height, &found, channels), stbi_image_free);
    if (!pixels)
        return Error{
            fmt::format("no readable picture: {}", stbi_failure_reason()), {file.string()}};
    Image image(width, height, channels == 0 ? found : channels);
    image.bytes.assign(pixels.get(), pixels.get() + image.bytes.size());
    return image;
}

} // namespace engine
