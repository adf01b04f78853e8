// Shader text: where it comes from, how includes and defines are expanded, and how the driver's
// messages find their way back to the file that a person wrote. No OpenGL here.

#pragma once

#include "engine/core/result.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gpu {

/// One file embedded at build.
struct ShaderFile {
    std::string_view path; ///< below the virtual root: "include/normal.glsl"
    std::string_view text;
};

/// A module's shaders folder under its virtual root. embed_shaders() in CMake makes one.
struct ShaderFolder {
    std::string_view virtual_root; ///< "render": files are named "render/gbuffer.vert"
    std::span<const ShaderFile> files;
    std::string_view disk_path = {}; ///< set: the files are read from there, and may change
};

/// Reads a file by its virtual name. Errors: no such file, with the nearest name.
using ShaderReader = std::function<engine::Result<std::string>(const std::string& name)>;

/// The file behind a virtual name, where its folder is read from disk.
std::optional<std::filesystem::path>
disk_file(std::span<const ShaderFolder> folders, std::string_view name);

/// Reads from the folders: from disk where they have a disk path, else from the embedded text.
engine::Result<std::string>
read_shader(std::span<const ShaderFolder> folders, const std::string& name);

/// A shader with its includes put in. There are no #line directives: Mesa forgets their file number
/// in most of its messages, so the lines of the expanded text are looked up here instead.
struct ExpandedShader {
    std::string text;                       ///< what the driver gets
    std::vector<std::string> files;         ///< virtual names, the main file first, each once
    std::vector<engine::SourcePlace> lines; ///< where each line of the text was written
};

/// Puts in every `#include "root/path"` line (each file once, at its first place, whatever #if
/// surrounds it) and the defines after #version. `#include <...>` and `#pragma once`, which headers
/// shared with C++ have, become empty lines.
///
/// @param name    of the main file, whose first directive is #version
/// @param defines "NAME" or "NAME=VALUE"
/// Errors: a missing file, at the line which includes it; a main file without #version.
engine::Result<ExpandedShader> expand_shader(
    const std::string& name, std::span<const std::string> defines, const ShaderReader& read);

/// A driver's log with the places that people know: "0(17) : error" and "0:17(4): error" become
/// "render/include/foo.glsl:3: error". Lines of other forms stay as they are.
std::string readable_log(std::string_view log, const ExpandedShader& shader);

/// Makes an error of a driver's log: its first error that names a place, then the other lines.
engine::Error error_from_log(std::string_view log, const ExpandedShader& shader);

} // namespace gpu
