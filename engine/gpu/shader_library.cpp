#include "engine/gpu/shader_library.hpp"

#include "engine/core/check.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>
#include <string_view>
#include <system_error>

#include "embedded/gpu_shaders.hpp"

namespace gpu {

namespace {

using Identifiers = std::set<std::string, std::less<>>;

bool starts_identifier(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool continues_identifier(char c) {
    return starts_identifier(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

void collect_identifiers(std::string_view text, Identifiers& identifiers) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!starts_identifier(text[i])) continue;
        const std::size_t start = i;
        while (i < text.size() && continues_identifier(text[i]))
            ++i;
        identifiers.emplace(text.substr(start, i - start));
    }
}

/// GL_VERTEX_SHADER for "render/gbuffer.vert", and so on. @pre the name ends in .vert, .frag or
/// .comp
GLenum stage_of(std::string_view name) {
    if (name.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (name.ends_with(".frag")) return GL_FRAGMENT_SHADER;
    CHECK(name.ends_with(".comp"));
    return GL_COMPUTE_SHADER;
}

engine::Result<ShaderHandle> compile_stage(const std::string& name, const ExpandedShader& source) {
    ShaderHandle shader(glCreateShader(stage_of(name)));
    label_object(GL_SHADER, shader.name(), name);
    const char* text = source.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;

    GLint length = 0;
    glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader.name(), length, nullptr, log.data());
    engine::Error error = error_from_log(log, source);
    if (error.place.file.empty()) error.place.file = name;
    return error;
}

engine::Result<void> link(const ProgramHandle& program, const std::string& name) {
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return {};

    GLint length = 0;
    glGetProgramiv(program.name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program.name(), length, nullptr, log.data());
    engine::Error error = error_from_log(log, {});
    error.message = fmt::format("does not link: {}", error.message);
    error.place.file = name;
    return error;
}

std::filesystem::file_time_type time_of(const std::filesystem::path& path) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(path, missing);
    return missing ? std::filesystem::file_time_type::min() : time;
}

} // namespace

ShaderLibrary::ShaderLibrary(std::vector<ShaderFolder> folders) : folders_(std::move(folders)) {
    folders_.push_back(embedded::gpu_shaders());
}

engine::Result<const Program*> ShaderLibrary::graphics(
    const std::string& vertex, const std::string& fragment, const Defines& defines) {
    return get({{vertex, fragment}, defines});
}

engine::Result<const Program*>
ShaderLibrary::compute(const std::string& compute, const Defines& defines) {
    return get({{compute}, defines});
}

engine::Result<const Program*> ShaderLibrary::get(Key key) {
    auto known = entries_.find(key);
    if (known == entries_.end()) {
        Entry entry;
        engine::Result<Program> program = compile(key, entry.watched);
        if (program) {
            entry.program = std::make_unique<Program>(*std::move(program));
        } else {
            entry.error = program.error();
        }
        known = entries_.emplace(std::move(key), std::move(entry)).first;
    }
    const Entry& entry = known->second;
    if (entry.program == nullptr) return entry.error;
    return entry.program.get();
}

engine::Result<Program> ShaderLibrary::compile(const Key& key, std::vector<WatchedFile>& watched) {
    // Watched from before it is read, so that no change falls between; a missing file is watched
    // too.
    const ShaderReader read = [&](const std::string& name) {
        watch(name, watched);
        return read_shader(folders_, name);
    };
    ++compile_count_;
    ProgramHandle handle(glCreateProgram());
    Identifiers identifiers;
    std::vector<ShaderHandle> stages;
    for (const std::string& file : key.files) {
        engine::Result<ExpandedShader> source = expand_shader(file, key.defines, read);
        if (!source) return source.error();
        engine::Result<ShaderHandle> stage = compile_stage(file, *source);
        if (!stage) return stage.error();
        collect_identifiers(source->text, identifiers);
        glAttachShader(handle.name(), stage->name());
        stages.push_back(*std::move(stage));
    }
    label_object(GL_PROGRAM, handle.name(), key.files.back());
    const engine::Result<void> linked = link(handle, key.files.back());
    if (!linked) return linked.error();
    for (const ShaderHandle& stage : stages)
        glDetachShader(handle.name(), stage.name());
    return Program(std::move(handle), std::move(identifiers));
}

void ShaderLibrary::watch(const std::string& name, std::vector<WatchedFile>& watched) const {
    const auto path = disk_file(folders_, name);
    if (path) watched.push_back({*path, time_of(*path)});
}

std::vector<engine::Error> ShaderLibrary::poll() {
    constexpr auto kInterval = std::chrono::milliseconds(500);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_poll_) return {};
    next_poll_ = now + kInterval;
    return poll_now();
}

std::vector<engine::Error> ShaderLibrary::poll_now() {
    std::vector<engine::Error> errors;
    for (auto& [key, entry] : entries_) {
        bool changed = false;
        for (const WatchedFile& file : entry.watched)
            changed |= time_of(file.path) != file.time;
        if (!changed) continue;

        entry.watched.clear();
        engine::Result<Program> program = compile(key, entry.watched);
        if (!program) {
            entry.error = program.error();
            errors.push_back(entry.error);
        } else if (entry.program == nullptr) {
            entry.program = std::make_unique<Program>(*std::move(program));
        } else {
            *entry.program = *std::move(program); // in place: the pointers given out stay good
        }
    }
    return errors;
}

} // namespace gpu
