#include "engine/gpu/context.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace gpu {

namespace {

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString(name);
    if (text == nullptr) return "unknown";
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): unsigned bytes of plain text
    return reinterpret_cast<const char*>(text);
}

GLint gl_integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

bool is_software(std::string_view renderer) {
    constexpr std::array<std::string_view, 4> kRasterisers = {
        "llvmpipe", "softpipe", "swrast", "Software"};
    for (const std::string_view rasteriser : kRasterisers) {
        if (renderer.find(rasteriser) != std::string_view::npos) return true;
    }
    return false;
}

DeviceInfo device_info(std::string platform) {
    DeviceInfo info;
    info.vendor = gl_string(GL_VENDOR);
    info.renderer = gl_string(GL_RENDERER);
    info.version = gl_string(GL_VERSION);
    info.platform = std::move(platform);
    info.software = is_software(info.renderer);
    info.max_texture_size = gl_integer(GL_MAX_TEXTURE_SIZE);
    info.max_array_layers = gl_integer(GL_MAX_ARRAY_TEXTURE_LAYERS);
    info.max_color_attachments = gl_integer(GL_MAX_COLOR_ATTACHMENTS);
    info.uniform_alignment_bytes = gl_integer(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT);
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &info.max_anisotropy);
    }
    return info;
}

void set_conventions() {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    // Rows of pixels in memory have no padding.
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

bool environment_wants_fatal_errors() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets variables while the engine runs
    const char* wish = std::getenv("GNOMON_GL_ERRORS");
    return wish != nullptr && std::string_view(wish) == "fatal";
}

} // namespace

Context::Context(NativeContext native, const ContextOptions& options)
    : native_(std::move(native)),
      device_(device_info(native_.platform)),
      errors_fatal_(options.errors_fatal || environment_wants_fatal_errors()) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS); // a fatal message leaves the guilty call on the stack
    glDebugMessageCallback(&Context::on_message, this);
    set_conventions();
}

Context::~Context() {
    make_current();
    glDebugMessageCallback(nullptr, nullptr);
}

void Context::on_message(
    GLenum source,
    GLenum type,
    GLuint /*id*/,
    GLenum severity,
    GLsizei length,
    const GLchar* text,
    const void* user) {
    // A shader that does not compile is an error of its file, which the shader library returns.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): the constructor's `this`, kept as
    // const
    auto* context = static_cast<Context*>(const_cast<void*>(user));
    context->take_message(type, severity, std::string(text, static_cast<std::size_t>(length)));
}

void Context::take_message(GLenum type, GLenum severity, std::string text) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    const bool error = type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH;
    ++(error ? error_count_ : warning_count_);
    if (seen_.insert(text).second) {
        fmt::print(stderr, "OpenGL {}: {}\n", error ? "error" : "warning", text);
        messages_.push_back({error, std::move(text)});
    }
    if (error && errors_fatal_) std::abort();
}

void Context::finish() const {
    glFinish();
}

} // namespace gpu
