// Materials and their base colour pictures out of glTF. Pictures that nothing here samples are not
// decoded.

#include "engine/scene/gltf_reader.hpp"

#include <stb/stb_image.h>

#include <array>
#include <memory>
#include <utility>

namespace scene {

namespace {

/// A picture may have this many pixels, and this many more for each of its compressed bytes.
constexpr std::uint64_t kFreePixels = 1U << 22U;
constexpr std::uint64_t kPixelsPerByte = 1024;

/// glTF knows two formats; the decoder knows more, which stay unused.
bool is_png_or_jpeg(std::span<const std::uint8_t> bytes) {
    const bool png = bytes.size() > 8 && bytes[0] == 0x89 && bytes[1] == 'P' && bytes[2] == 'N'
                     && bytes[3] == 'G';
    const bool jpeg = bytes.size() > 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
    return png || jpeg;
}

engine::Result<engine::Image> decode(std::span<const std::uint8_t> bytes, MemoryBudget& budget) {
    if (!is_png_or_jpeg(bytes)) return engine::Error{"neither PNG nor JPEG"};
    if (bytes.size() > std::numeric_limits<int>::max()) return engine::Error{"larger than 2 GB"};
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0)
        return engine::Error{stbi_failure_reason()};
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (pixels > kFreePixels + kPixelsPerByte * bytes.size() || !budget.take(4 * pixels))
        return engine::Error{
            fmt::format("{} x {} pixels are more than so small a file may unpack", width, height)};
    const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
    if (!decoded) return engine::Error{stbi_failure_reason()};
    engine::Image image(width, height, 4);
    image.bytes.assign(decoded.get(), decoded.get() + image.bytes.size());
    return image;
}

engine::Result<Wrap> wrap_mode(const std::string& place, int value) {
    switch (value) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
        return Wrap::repeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        return Wrap::mirror;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return Wrap::clamp;
    default:
        return engine::Error{fmt::format("{}: wrap mode {} is not known", place, value)};
    }
}

engine::Result<void>
read_sampler(GltfReader& reader, const std::string& place, int index, Texture& texture) {
    const auto sampler = optional_index(place, "sampler", index, reader.source.samplers.size());
    if (!sampler) return sampler.error();
    if (!*sampler) return {};
    const tinygltf::Sampler& found = reader.source.samplers[**sampler];
    const auto wrap_u = wrap_mode(place, found.wrapS);
    if (!wrap_u) return wrap_u.error();
    const auto wrap_v = wrap_mode(place, found.wrapT);
    if (!wrap_v) return wrap_v.error();
    if (found.magFilter != -1 && found.magFilter != TINYGLTF_TEXTURE_FILTER_NEAREST
        && found.magFilter != TINYGLTF_TEXTURE_FILTER_LINEAR)
        return engine::Error{
            fmt::format("{}: magnification filter {} is not known", place, found.magFilter)};
    texture.wrap_u = *wrap_u;
    texture.wrap_v = *wrap_v;
    texture.nearest = found.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    return {};
}

/// The picture's bytes as stored: in a buffer view, or as the parser found them at its URI.
engine::Result<std::span<const std::uint8_t>>
picture_bytes(const GltfReader& reader, const tinygltf::Image& image) {
    if (image.bufferView >= 0) return view_bytes(reader.source, image.bufferView);
    if (image.image.empty()) return engine::Error{fmt::format("no file '{}'", image.uri)};
    return std::span<const std::uint8_t>(image.image);
}

/// @return index into Model::textures, or kNoTexture with a warning where the picture can not be
/// had
engine::Result<std::uint32_t> read_texture(GltfReader& reader, std::uint32_t index) {
    const tinygltf::Texture& source = reader.source.textures[index];
    const std::string place = label("texture", index, source.name);
    const auto image_index =
        optional_index(place, "image", source.source, reader.source.images.size());
    if (!image_index) return image_index.error();
    Texture texture;
    if (const auto read = read_sampler(reader, place, source.sampler, texture); !read)
        return read.error();
    if (!*image_index) {
        reader.warn(place + ": has no picture that can be read; drawn white");
        return kNoTexture;
    }
    const tinygltf::Image& image = reader.source.images[**image_index];
    const auto bytes = picture_bytes(reader, image);
    auto decoded =
        bytes ? decode(*bytes, reader.pictures) : engine::Result<engine::Image>(bytes.error());
    if (!decoded) {
        reader.warn(fmt::format(
            "{}: {}; drawn white",
            label("image", **image_index, image.name),
            decoded.error().message));
        return kNoTexture;
    }
    texture.name = !image.name.empty() ? image.name : image.uri;
    texture.image = std::move(*decoded);
    reader.model.textures.push_back(std::move(texture));
    return static_cast<std::uint32_t>(reader.model.textures.size() - 1);
}

engine::Result<void> read_alpha(
    GltfReader& reader,
    const std::string& place,
    const tinygltf::Material& source,
    Material& material) {
    const auto cutoff = bounded(place, "alphaCutoff", source.alphaCutoff, 0.0);
    if (!cutoff) return cutoff.error();
    if (source.alphaMode == "OPAQUE") return {};
    if (source.alphaMode == "MASK") {
        material.alpha_masked = true;
        material.alpha_cutoff = *cutoff;
        return {};
    }
    if (source.alphaMode != "BLEND")
        return engine::Error{
            fmt::format("{}: alpha mode '{}' is not known", place, source.alphaMode)};
    reader.warn(place + ": BLEND is drawn as MASK at 0.5");
    material.alpha_masked = true;
    return {};
}

engine::Result<void> read_base_color(
    GltfReader& reader,
    const std::string& place,
    const tinygltf::PbrMetallicRoughness& source,
    std::vector<std::optional<std::uint32_t>>& textures,
    Material& material) {
    if (source.baseColorFactor.size() != 4)
        return engine::Error{fmt::format(
            "{}: a base colour of {} numbers, expected 4", place, source.baseColorFactor.size())};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto value = bounded(place, "baseColorFactor", source.baseColorFactor[i], 0.0);
        if (!value) return value.error();
        material.base_color[static_cast<int>(i)] = *value;
    }
    const tinygltf::TextureInfo& info = source.baseColorTexture;
    const auto texture = optional_index(place, "texture", info.index, textures.size());
    if (!texture) return texture.error();
    if (!*texture) return {};
    if (info.extensions.contains("KHR_texture_transform"))
        reader.warn(place + ": KHR_texture_transform is ignored");
    auto& known = textures[**texture];
    if (!known) {
        const auto read = read_texture(reader, **texture);
        if (!read) return read.error();
        known = *read;
    }
    material.texture = *known;
    return {};
}

} // namespace

engine::Result<void> read_materials(GltfReader& reader) {
    std::vector<std::optional<std::uint32_t>> textures(reader.source.textures.size());
    for (std::size_t i = 0; i < reader.source.materials.size(); ++i) {
        const tinygltf::Material& source = reader.source.materials[i];
        const std::string place = label("material", i, source.name);
        Material material;
        material.name = source.name;
        material.double_sided = source.doubleSided;
        if (const auto read =
                read_base_color(reader, place, source.pbrMetallicRoughness, textures, material);
            !read)
            return read.error();
        if (const auto read = read_alpha(reader, place, source, material); !read)
            return read.error();
        reader.model.materials.push_back(std::move(material));
        reader.uv_sets.push_back(source.pbrMetallicRoughness.baseColorTexture.texCoord);
    }
    return {};
}

} // namespace scene
