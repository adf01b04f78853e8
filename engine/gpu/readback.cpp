#include "engine/gpu/readback.hpp"

#include "engine/core/check.hpp"

#include <algorithm>

namespace gpu {

namespace {

/// Turns rows round, so that the first becomes the last.
template <class T>
void flip_rows(std::vector<T>& values, std::size_t row_length) {
    if (row_length == 0) return;
    const std::size_t rows = values.size() / row_length;
    for (std::size_t low = 0, high = rows; low + 1 < high; ++low) {
        --high;
        const auto low_row = values.begin() + static_cast<std::ptrdiff_t>(low * row_length);
        const auto high_row = values.begin() + static_cast<std::ptrdiff_t>(high * row_length);
        std::swap_ranges(low_row, low_row + static_cast<std::ptrdiff_t>(row_length), high_row);
    }
}

/// Fills `values`, sized for the layer, with pixels converted to (format, type), and flips them.
template <class T>
void read_layer(
    const Texture& texture,
    int level,
    int layer,
    GLenum format,
    GLenum type,
    std::vector<T>& values) {
    const int height = texture.height(level);
    CHECK_LT(layer, texture.layers());
    glGetTextureSubImage(
        texture.name(),
        level,
        0,
        0,
        layer,
        texture.width(level),
        height,
        1,
        format,
        type,
        static_cast<GLsizei>(values.size() * sizeof(T)),
        values.data());
    flip_rows(values, values.size() / static_cast<std::size_t>(height));
}

template <class T>
Pixels<T> read_pixels(const Texture& texture, int level, int layer, GLenum format, GLenum type) {
    Pixels<T> pixels = {texture.width(level), texture.height(level), {}};
    pixels.values.resize(
        static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height));
    read_layer(texture, level, layer, format, type, pixels.values);
    return pixels;
}

} // namespace

engine::Image read_image(const Texture& texture, int level, int layer) {
    int channels = 4;
    GLenum format = GL_RGBA;
    if (texture.format() == Format::r8) {
        channels = 1;
        format = GL_RED;
    } else if (texture.format() == Format::rg8) {
        channels = 3;
        format = GL_RGB;
    } else {
        CHECK(texture.format() == Format::rgba8 || texture.format() == Format::srgb8_alpha8);
    }
    engine::Image image(texture.width(level), texture.height(level), channels);
    read_layer(texture, level, layer, format, GL_UNSIGNED_BYTE, image.bytes);
    return image;
}

Pixels<std::uint32_t> read_uints(const Texture& texture, int level, int layer) {
    CHECK(traits(texture.format()).pixel_format == GL_RED_INTEGER);
    return read_pixels<std::uint32_t>(texture, level, layer, GL_RED_INTEGER, GL_UNSIGNED_INT);
}

Pixels<glm::uvec2> read_uint_pairs(const Texture& texture, int level, int layer) {
    CHECK(texture.format() == Format::rg32ui);
    return read_pixels<glm::uvec2>(texture, level, layer, GL_RG_INTEGER, GL_UNSIGNED_INT);
}

Pixels<float> read_floats(const Texture& texture, int level, int layer) {
    CHECK(!traits(texture.format()).integer && !traits(texture.format()).depth);
    return read_pixels<float>(texture, level, layer, GL_RED, GL_FLOAT);
}

Pixels<glm::vec4> read_vectors(const Texture& texture, int level, int layer) {
    CHECK(!traits(texture.format()).integer && !traits(texture.format()).depth);
    return read_pixels<glm::vec4>(texture, level, layer, GL_RGBA, GL_FLOAT);
}

Pixels<float> read_depth(const Texture& texture, int level, int layer) {
    CHECK(traits(texture.format()).depth);
    return read_pixels<float>(texture, level, layer, GL_DEPTH_COMPONENT, GL_FLOAT);
}

Pixels<std::uint8_t> read_stencil(const Texture& texture, int level, int layer) {
    CHECK(traits(texture.format()).stencil);
    return read_pixels<std::uint8_t>(texture, level, layer, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
}

engine::Image read_window(const Framebuffer& window) {
    engine::Image image(window.width(), window.height(), 3);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, window.name());
    glReadPixels(
        0, 0, window.width(), window.height(), GL_RGB, GL_UNSIGNED_BYTE, image.bytes.data());
    flip_rows(image.bytes, static_cast<std::size_t>(window.width()) * 3);
    return image;
}

} // namespace gpu
