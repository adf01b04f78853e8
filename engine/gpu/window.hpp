// A window with an OpenGL 4.5 core context.

#pragma once

#include "engine/core/result.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/framebuffer.hpp"

#include <glm/glm.hpp>

#include <memory>
#include <string>

struct GLFWwindow;

namespace gpu {

struct WindowOptions {
    std::string title = "Gnomon";
    int width = 1280; ///< screen units
    int height = 720;
    bool vsync = true;
    bool visible = true;
    ContextOptions context = {};
};

class Window {
public:
    [[nodiscard]] Context& context() { return *context_; }

    /// Lets the system deliver events. Call once per frame.
    void poll();
    /// Shows what was drawn into framebuffer().
    void swap();

    [[nodiscard]] bool should_close() const;
    void request_close();

    /// Pixels, both 0 while minimised; may differ from the window's size in screen units.
    [[nodiscard]] glm::ivec2 size_px() const;
    /// The window's framebuffer at its present size.
    [[nodiscard]] Framebuffer framebuffer() const;

    void set_title(const std::string& title);
    /// Hides the pointer and lets it move without end, for looking round.
    void capture_pointer(bool on);

    [[nodiscard]] GLFWwindow* native() const { return window_; }

private:
    friend engine::Result<std::unique_ptr<Window>>
    make_window_context(const WindowOptions& options);
    Window(GLFWwindow* window, std::unique_ptr<Context> context)
        : window_(window),
          context_(std::move(context)) {}

    GLFWwindow* window_; ///< owned by the context
    std::unique_ptr<Context> context_;
};

/// Errors: no display, or no OpenGL 4.5 on it.
engine::Result<std::unique_ptr<Window>> make_window_context(const WindowOptions& options = {});

} // namespace gpu
