#include "engine/scene/gltf.hpp"

#include "engine/scene/gltf_reader.hpp"
#include "engine/scene/gltf_text.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <system_error>

namespace scene {

namespace {

/// What may stand in extensionsRequired; materials are reduced to their base colour in any case.
bool understood(const std::string& extension) {
    constexpr std::array kUnderstood = std::to_array<std::string_view>(
        {"KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform"});
    return std::find(kUnderstood.begin(), kUnderstood.end(), extension) != kUnderstood.end()
           || extension.starts_with("KHR_materials_");
}

engine::Result<std::vector<std::uint8_t>> read_bytes(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return engine::Error{"no such file"};
    std::ifstream stream(file, std::ios::binary);
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || !stream) return engine::Error{"can not be opened"};
    std::vector<std::uint8_t> bytes(size);
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
        return engine::Error{"can not be read"};
    return bytes;
}

// Call-backs of the parser: files beside the model, or none at all.

bool file_exists(const std::string& file, void* /*user*/) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}
bool no_file_exists(const std::string& /*file*/, void* /*user*/) {
    return false;
}
std::string same_path(const std::string& file, void* /*user*/) {
    return file;
}

bool read_whole_file(
    std::vector<unsigned char>* out, std::string* error, const std::string& file, void* /*user*/) {
    auto bytes = read_bytes(file);
    if (!bytes) {
        *error = bytes.error().message;
        return false;
    }
    *out = std::move(*bytes);
    return true;
}

/// Keeps a picture as it is stored; what the materials need is decoded later, when its place is
/// checked.
bool keep_picture(
    tinygltf::Image* image,
    const int /*index*/,
    std::string* /*error*/,
    std::string* /*warning*/,
    int /*width*/,
    int /*height*/,
    const unsigned char* bytes,
    int size,
    void* /*user*/) {
    image->as_is = true;
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

/// What the parser complained of, less what is no fault: inverse bind matrices may be absent.
std::string first_complaint(std::string complaints) {
    constexpr std::string_view kHarmless = "'inverseBindMatrices' property is missing in Skin.\n";
    for (auto at = complaints.find(kHarmless); at != std::string::npos;
         at = complaints.find(kHarmless))
        complaints.erase(at, kHarmless.size());
    return complaints.substr(0, complaints.find('\n'));
}

/// @param folder where the file's own files lie; empty: nowhere
engine::Result<tinygltf::Model>
parse(std::span<const std::uint8_t> bytes, const std::string& folder) {
    const auto text = gltf_text(bytes);
    if (!text) return text.error();
    if (const auto checked = check_gltf_text(*text); !checked) return checked.error();
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        return engine::Error{"larger than 4 GB"};

    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_picture, nullptr);
    parser.SetFsCallbacks(
        {folder.empty() ? no_file_exists : file_exists,
         same_path,
         read_whole_file,
         nullptr,
         nullptr});
    tinygltf::Model model;
    std::string error;
    std::string warning; // about missing pictures alone, which read_materials tells better
    const auto size = static_cast<unsigned int>(bytes.size());
    try {
        const bool read =
            is_binary_gltf(bytes)
                ? parser.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), size, folder)
                : parser.LoadASCIIFromString(&model, &error, &warning, text->data(), size, folder);
        if (!read && error.empty()) error = "unknown reason";
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    if (const std::string complaint = first_complaint(error); !complaint.empty())
        return engine::Error{"not readable as glTF: " + complaint};
    return model;
}

engine::Result<void> check_asset(const tinygltf::Model& source) {
    if (!source.asset.version.starts_with("2."))
        return engine::Error{fmt::format("glTF version '{}', expected 2.0", source.asset.version)};
    for (const std::string& extension : source.extensionsRequired)
        if (!understood(extension))
            return engine::Error{
                fmt::format("it requires the extension '{}', which is not understood", extension)};
    return {};
}

std::uint64_t total_bytes(const tinygltf::Model& source, std::size_t file_bytes) {
    std::uint64_t total = file_bytes;
    for (const tinygltf::Buffer& buffer : source.buffers)
        total += buffer.data.size();
    for (const tinygltf::Image& image : source.images)
        total += image.image.size();
    return total;
}

engine::Result<Model>
load(std::span<const std::uint8_t> bytes, const std::string& name, const std::string& folder) {
    const auto refused = [&](const engine::Error& error) {
        return engine::Error{error.message, {name}};
    };
    const auto source = parse(bytes, folder);
    if (!source) return refused(source.error());
    if (const auto checked = check_asset(*source); !checked) return refused(checked.error());

    Model model;
    model.file = name;
    GltfReader reader(*source, model, total_bytes(*source, bytes.size()));
    for (const auto part :
         {read_materials,
          read_meshes,
          read_cameras_and_lights,
          read_nodes,
          read_skins,
          read_animations})
        if (const auto read = part(reader); !read) return refused(read.error());
    if (const auto checked = check_reach(model); !checked) return refused(checked.error());
    return model;
}

} // namespace

engine::Result<Model> load_gltf(const std::filesystem::path& file) {
    const auto bytes = read_bytes(file.string());
    if (!bytes) return engine::Error{bytes.error().message, {file.string()}};
    const std::filesystem::path folder = file.parent_path();
    return load(*bytes, file.string(), folder.empty() ? "." : folder.string());
}

engine::Result<Model>
load_gltf_bytes(std::span<const std::uint8_t> bytes, const std::string& name) {
    return load(bytes, name, {});
}

} // namespace scene
