#include "engine/gpu/shader_source.hpp"

#include "engine/core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace gpu {

namespace {

/// The folder that a virtual name starts with, and the rest of the name; null when there is none.
const ShaderFolder*
folder_of(std::span<const ShaderFolder> folders, std::string_view name, std::string_view& path) {
    const std::size_t slash = name.find('/');
    if (slash == std::string_view::npos) return nullptr;
    const auto folder =
        std::find_if(folders.begin(), folders.end(), [&](const ShaderFolder& candidate) {
            return candidate.virtual_root == name.substr(0, slash);
        });
    if (folder == folders.end()) return nullptr;
    path = name.substr(slash + 1);
    return &*folder;
}

std::vector<std::string> virtual_names(const ShaderFolder& folder) {
    std::vector<std::string> names;
    if (folder.disk_path.empty()) {
        for (const ShaderFile& file : folder.files) {
            names.push_back(fmt::format("{}/{}", folder.virtual_root, file.path));
        }
        return names;
    }
    const std::filesystem::path root(folder.disk_path);
    std::error_code failed;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root, failed)) {
        const std::string path = entry.path().lexically_relative(root).generic_string();
        names.push_back(fmt::format("{}/{}", folder.virtual_root, path));
    }
    std::sort(names.begin(), names.end());
    return names;
}

engine::Error no_such_file(std::span<const ShaderFolder> folders, const std::string& name) {
    std::vector<std::string> names;
    for (const ShaderFolder& folder : folders) {
        std::vector<std::string> of_folder = virtual_names(folder);
        std::move(of_folder.begin(), of_folder.end(), std::back_inserter(names));
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return {fmt::format("no shader file '{}'{}", name, engine::did_you_mean(name, views))};
}

} // namespace

std::optional<std::filesystem::path>
disk_file(std::span<const ShaderFolder> folders, std::string_view name) {
    std::string_view path;
    const ShaderFolder* folder = folder_of(folders, name, path);
    if (folder == nullptr || folder->disk_path.empty()) return std::nullopt;
    return std::filesystem::path(folder->disk_path) / path;
}

engine::Result<std::string>
read_shader(std::span<const ShaderFolder> folders, const std::string& name) {
    if (const auto path = disk_file(folders, name)) {
        std::ifstream file(*path, std::ios::binary);
        if (!file) return no_such_file(folders, name);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }
    std::string_view path;
    const ShaderFolder* folder = folder_of(folders, name, path);
    if (folder == nullptr) return no_such_file(folders, name);
    const auto file =
        std::find_if(folder->files.begin(), folder->files.end(), [path](const ShaderFile& one) {
            return one.path == path;
        });
    if (file == folder->files.end()) return no_such_file(folders, name);
    return std::string(file->text);
}

} // namespace gpu
