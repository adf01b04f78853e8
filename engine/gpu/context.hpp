// An OpenGL 4.5 core context without a window, made current on the calling thread.
//
// Conventions set at its start: clip control LOWER_LEFT and ZERO_TO_ONE. Depth is reversed: clear
// to 0, test with GREATER, 1 at the near plane, exactly 0 at infinity; projections have no far
// plane. Cube maps are filtered across their edges.

#pragma once

#include "engine/core/result.hpp"

#include <epoxy/gl.h>

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace gpu {

struct ContextOptions {
    bool debug = true; ///< asks the driver for its debug messages
    /// An OpenGL error, or a message of high severity, aborts with its text. GNOMON_GL_ERRORS=fatal
    /// in the environment does the same.
    bool errors_fatal = false;
};

/// What the context runs on.
struct DeviceInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string platform;     ///< "EGL device", "EGL surfaceless" or "window"
    bool software = false;    ///< a rasteriser on the CPU
    int max_texture_size = 0; ///< pixels a side
    int max_array_layers = 0;
    int max_color_attachments = 0;
    int uniform_alignment_bytes = 0; ///< of offsets in Buffer::bind_uniform
    float max_anisotropy = 1.0F;
};

/// A message of the driver's, kept.
struct DriverMessage {
    bool error = false; ///< an error, or of high severity
    std::string text;
};

/// What a maker of contexts hands over: a native context, current on this thread.
struct NativeContext {
    std::shared_ptr<void> owner; ///< destroys the native context with its last copy
    std::function<void()> make_current;
    std::string platform; ///< for DeviceInfo
};

class Context {
public:
    Context(NativeContext native, const ContextOptions& options);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    Context(Context&&) = delete;
    Context& operator=(Context&&) = delete;

    /// Makes it current on this thread again, after another context was.
    void make_current() { native_.make_current(); }

    /// Waits until the device has done all it was asked.
    void finish() const;

    [[nodiscard]] const DeviceInfo& device() const { return device_; }

    /// Each text once, errors and warnings, in order of appearance.
    [[nodiscard]] const std::vector<DriverMessage>& messages() const { return messages_; }
    [[nodiscard]] int error_count() const { return error_count_; }
    [[nodiscard]] int warning_count() const { return warning_count_; }

private:
    static void GLAPIENTRY on_message(
        GLenum source,
        GLenum type,
        GLuint id,
        GLenum severity,
        GLsizei length,
        const GLchar* text,
        const void* user);
    void take_message(GLenum type, GLenum severity, std::string text);

    NativeContext native_;
    DeviceInfo device_;
    bool errors_fatal_;
    std::vector<DriverMessage> messages_;
    std::set<std::string> seen_;
    int error_count_ = 0;
    int warning_count_ = 0;
};

/// A context that draws into framebuffers only. Each EGL device is tried, hardware first, then
/// Mesa's surfaceless platform; LIBGL_ALWAYS_SOFTWARE leaves hardware out. Errors: no OpenGL 4.5 on
/// this machine, with what was tried. A command line exits with 77 then.
engine::Result<std::unique_ptr<Context>> make_headless_context(const ContextOptions& options = {});

} // namespace gpu
