// Textures and samplers. Storage is immutable: a texture of another size is another texture.

#pragma once

#include "engine/gpu/handle.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace gpu {

enum class Format : std::uint8_t {
    r8,
    rg8,
    rgba8,
    srgb8_alpha8, ///< for reading colours; nothing is rendered into it
    rgb10_a2,
    r16f,
    rg16f,
    rgba16f,
    r11g11b10f,
    r32f,
    rg32f,
    rgba32f,
    r8ui,
    r16ui,
    r32ui,
    rg32ui,
    rgba32ui,
    rgb10_a2ui,
    depth16,
    depth32f,
    depth32f_stencil8,
};

/// What a format is to OpenGL. One row per format.
struct FormatTraits {
    GLenum internal_format = 0;
    GLenum pixel_format = 0; ///< of one pixel in memory, for uploads and reads
    GLenum pixel_type = 0;
    int pixel_bytes = 0; ///< in memory and on the device
    bool integer = false;
    bool depth = false;
    bool stencil = false;
};
const FormatTraits& traits(Format format);

enum class Filter : std::uint8_t { nearest, linear };
enum class MipFilter : std::uint8_t { none, nearest, linear };
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge, clamp_to_border };

/// How a texture is read. `compare` makes a depth texture answer a sampler*Shadow: 1 where the
/// reference is greater than or equal to the stored depth, that is, nearer or as near (depth is
/// reversed).
struct Sampling {
    Filter min = Filter::nearest;
    Filter mag = Filter::nearest;
    MipFilter mip = MipFilter::none;
    Wrap wrap = Wrap::clamp_to_edge;
    std::optional<Wrap> wrap_v = {};    ///< upward, where it differs from `wrap`
    glm::vec4 border = glm::vec4(0.0F); ///< for clamp_to_border
    bool compare = false;
    float max_anisotropy = 1.0F; ///< cut to what the device offers

    bool operator==(const Sampling&) const = default;
};

inline constexpr Sampling kLinear = {.min = Filter::linear, .mag = Filter::linear};

enum class TextureKind : std::uint8_t { plane, array, cube, cube_array };

struct TextureDescription {
    TextureKind kind = TextureKind::plane;
    Format format = Format::rgba8;
    int width = 1;
    int height = 1;
    int layers = 1; ///< of an array; cubes of a cube array
    int levels = 1; ///< mip levels; 0 for the whole chain
    Sampling sampling = {};
};

/// A region of one layer in pixels, origin bottom left.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const Rect&) const = default;
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// Sampling apart from a texture, for one texture read in two ways (compared, and as plain depth).
class Sampler {
public:
    Sampler() = default;
    Sampler(std::string_view label, const Sampling& sampling);

    [[nodiscard]] GLuint name() const { return handle_.name(); }

private:
    SamplerHandle handle_;
};

/// Empty when default constructed.
class Texture {
public:
    Texture() = default;

    /// @pre sizes and layers are at least 1 and within the device's limits; a cube is square
    Texture(std::string_view label, const TextureDescription& description);

    /// Writes pixels as the format's traits say, bottom row first, rows without padding.
    /// @param layer of an array; cube * 6 + face of cubes
    /// @pre pixels.size() is what the region takes
    void upload(std::span<const std::byte> pixels, int level = 0, int layer = 0);
    void upload(std::span<const std::byte> pixels, int level, int layer, const Rect& region);

    void make_mip_levels();

    /// Sets every texel of a level to zero, or to the bytes of one pixel.
    void clear(int level = 0);
    void clear(int level, std::span<const std::byte> pixel);

    /// Binds to a texture unit, read as the texture or the sampler says.
    void bind(unsigned unit) const;
    void bind(unsigned unit, const Sampler& sampler) const;

    enum class Access : std::uint8_t { read, write, read_write };

    /// Binds a level to an image unit, with all its layers.
    void bind_image(unsigned unit, Access access, int level = 0) const;

    [[nodiscard]] GLuint name() const { return handle_.name(); }
    [[nodiscard]] const TextureDescription& description() const { return description_; }
    [[nodiscard]] Format format() const { return description_.format; }
    [[nodiscard]] int width(int level = 0) const { return level_size(description_.width, level); }
    [[nodiscard]] int height(int level = 0) const { return level_size(description_.height, level); }
    [[nodiscard]] int levels() const { return description_.levels; } ///< never 0
    [[nodiscard]] int layers() const; ///< of an array; 6 a cube; 1 for a plane
    [[nodiscard]] std::uint64_t size_bytes() const { return device_bytes_.count(); }
    explicit operator bool() const { return static_cast<bool>(handle_); }

private:
    static int level_size(int size, int level) { return size >> level > 0 ? size >> level : 1; }

    TextureHandle handle_;
    DeviceBytes device_bytes_;
    TextureDescription description_;
};

} // namespace gpu
