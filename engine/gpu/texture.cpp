#include "engine/gpu/texture.hpp"

#include "engine/core/check.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <bit>

namespace gpu {

const FormatTraits& traits(Format format) {
    static constexpr std::array<FormatTraits, 21> kTraits = {{
        {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1},
        {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2},
        {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
        {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
        {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 4},
        {GL_R16F, GL_RED, GL_HALF_FLOAT, 2},
        {GL_RG16F, GL_RG, GL_HALF_FLOAT, 4},
        {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8},
        {GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV, 4},
        {GL_R32F, GL_RED, GL_FLOAT, 4},
        {GL_RG32F, GL_RG, GL_FLOAT, 8},
        {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
        {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, true},
        {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2, true},
        {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4, true},
        {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8, true},
        {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16, true},
        {GL_RGB10_A2UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT_2_10_10_10_REV, 4, true},
        {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2, false, true},
        {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4, false, true},
        {GL_DEPTH32F_STENCIL8,
         GL_DEPTH_STENCIL,
         GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
         8,
         false,
         true,
         true},
    }};
    return kTraits[static_cast<std::size_t>(format)];
}

namespace {

GLenum min_filter(const Sampling& sampling) {
    const bool linear = sampling.min == Filter::linear;
    switch (sampling.mip) {
    case MipFilter::none:
        return linear ? GL_LINEAR : GL_NEAREST;
    case MipFilter::nearest:
        return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    case MipFilter::linear:
        return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    }
    return GL_NEAREST;
}

GLenum wrap_mode(Wrap wrap) {
    static constexpr std::array<GLenum, 4> kModes = {
        GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER};
    return kModes[static_cast<std::size_t>(wrap)];
}

float offered_anisotropy(float wanted) {
    if (wanted <= 1.0F || !epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) return 1.0F;
    float most = 1.0F;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &most);
    return std::min(wanted, most);
}

/// Calls set(parameter, value) for each integer parameter and set_float for the others, so that
/// textures and samplers share one list.
template <class SetInt, class SetFloats>
void apply_sampling(const Sampling& sampling, SetInt set, SetFloats set_floats) {
    set(GL_TEXTURE_MIN_FILTER, min_filter(sampling));
    set(GL_TEXTURE_MAG_FILTER, sampling.mag == Filter::linear ? GL_LINEAR : GL_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        set(axis, wrap_mode(sampling.wrap));
    }
    if (sampling.wrap_v) set(GL_TEXTURE_WRAP_T, wrap_mode(*sampling.wrap_v));
    set_floats(GL_TEXTURE_BORDER_COLOR, glm::value_ptr(sampling.border));
    set(GL_TEXTURE_COMPARE_MODE, sampling.compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
    set(GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    const float anisotropy = offered_anisotropy(sampling.max_anisotropy);
    if (anisotropy > 1.0F) set_floats(GL_TEXTURE_MAX_ANISOTROPY, &anisotropy);
}

GLenum target_of(TextureKind kind) {
    static constexpr std::array<GLenum, 4> kTargets = {
        GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_ARRAY};
    return kTargets[static_cast<std::size_t>(kind)];
}

bool is_cube(TextureKind kind) {
    return kind == TextureKind::cube || kind == TextureKind::cube_array;
}

} // namespace

Sampler::Sampler(std::string_view label, const Sampling& sampling) {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    handle_ = SamplerHandle(name);
    label_object(GL_SAMPLER, name, label);
    apply_sampling(
        sampling,
        [name](GLenum parameter, GLenum value) {
            glSamplerParameteri(name, parameter, static_cast<GLint>(value));
        },
        [name](GLenum parameter, const float* values) {
            glSamplerParameterfv(name, parameter, values);
        });
}

Texture::Texture(std::string_view label, const TextureDescription& description)
    : description_(description) {
    CHECK_GE(description.width, 1);
    CHECK_GE(description.height, 1);
    CHECK_GE(description.layers, 1);
    CHECK(!is_cube(description.kind) || description.width == description.height);
    const bool layered =
        description.kind == TextureKind::array || description.kind == TextureKind::cube_array;
    CHECK(layered || description.layers == 1);

    const int longest = std::max(description.width, description.height);
    const int chain = static_cast<int>(std::bit_width(static_cast<unsigned>(longest)));
    description_.levels =
        description.levels == 0 ? chain : std::clamp(description.levels, 1, chain);

    GLuint name = 0;
    glCreateTextures(target_of(description.kind), 1, &name);
    handle_ = TextureHandle(name);
    label_object(GL_TEXTURE, name, label);
    const FormatTraits& format_traits = traits(description.format);
    if (layered) {
        glTextureStorage3D(
            name,
            levels(),
            format_traits.internal_format,
            description.width,
            description.height,
            layers());
    } else {
        glTextureStorage2D(
            name, levels(), format_traits.internal_format, description.width, description.height);
    }
    apply_sampling(
        description.sampling,
        [name](GLenum parameter, GLenum value) {
            glTextureParameteri(name, parameter, static_cast<GLint>(value));
        },
        [name](GLenum parameter, const float* values) {
            glTextureParameterfv(name, parameter, values);
        });

    std::uint64_t texels = 0;
    for (int level = 0; level < levels(); ++level) {
        texels += static_cast<std::uint64_t>(width(level))
                  * static_cast<std::uint64_t>(height(level))
                  * static_cast<std::uint64_t>(layers());
    }
    device_bytes_ = DeviceBytes(texels * static_cast<std::uint64_t>(format_traits.pixel_bytes));
}

int Texture::layers() const {
    return description_.layers * (is_cube(description_.kind) ? 6 : 1);
}

void Texture::upload(std::span<const std::byte> pixels, int level, int layer) {
    upload(pixels, level, layer, {0, 0, width(level), height(level)});
}

void Texture::upload(std::span<const std::byte> pixels, int level, int layer, const Rect& region) {
    const FormatTraits& format_traits = traits(format());
    CHECK_EQ(
        pixels.size(),
        static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height)
            * static_cast<std::size_t>(format_traits.pixel_bytes));
    if (description_.kind == TextureKind::plane) {
        glTextureSubImage2D(
            name(),
            level,
            region.x,
            region.y,
            region.width,
            region.height,
            format_traits.pixel_format,
            format_traits.pixel_type,
            pixels.data());
    } else {
        glTextureSubImage3D(
            name(),
            level,
            region.x,
            region.y,
            layer,
            region.width,
            region.height,
            1,
            format_traits.pixel_format,
            format_traits.pixel_type,
            pixels.data());
    }
}

void Texture::make_mip_levels() {
    glGenerateTextureMipmap(name());
}

void Texture::clear(int level) {
    clear(level, {});
}

void Texture::clear(int level, std::span<const std::byte> pixel) {
    const FormatTraits& format_traits = traits(format());
    CHECK(pixel.empty() || pixel.size() == static_cast<std::size_t>(format_traits.pixel_bytes));
    glClearTexImage(
        name(),
        level,
        format_traits.pixel_format,
        format_traits.pixel_type,
        pixel.empty() ? nullptr : pixel.data());
}

void Texture::bind(unsigned unit) const {
    CHECK(handle_);
    glBindTextureUnit(unit, name());
    glBindSampler(unit, 0);
}

void Texture::bind(unsigned unit, const Sampler& sampler) const {
    CHECK(handle_);
    glBindTextureUnit(unit, name());
    glBindSampler(unit, sampler.name());
}

void Texture::bind_image(unsigned unit, Access access, int level) const {
    static constexpr std::array<GLenum, 3> kAccess = {GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE};
    glBindImageTexture(
        unit,
        name(),
        level,
        GL_TRUE,
        0,
        kAccess[static_cast<std::size_t>(access)],
        traits(format()).internal_format);
}

} // namespace gpu
