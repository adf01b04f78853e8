#include "engine/gpu/window.hpp"

#include "engine/core/check.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace gpu {

namespace {

/// GLFW as a whole: started by the first window, ended with the last.
std::shared_ptr<void> glfw_library() {
    static std::weak_ptr<void> running; // GLFW itself is one per process
    std::shared_ptr<void> library = running.lock();
    if (library != nullptr) return library;
    if (glfwInit() == GLFW_FALSE) return nullptr;
    static char token = 0;
    library = std::shared_ptr<void>(&token, [](void*) { glfwTerminate(); });
    running = library;
    return library;
}

engine::Error glfw_failure(const char* what) {
    const char* text = nullptr;
    glfwGetError(&text);
    return {fmt::format("{}: {}", what, text == nullptr ? "GLFW gives no reason" : text)};
}

void set_hints(const WindowOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    // EGL here as in the headless context, so that both run on the same driver path.
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.context.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    // Passes draw into textures; the window shows the finished picture and needs no depth.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

} // namespace

void Window::poll() {
    CHECK(window_ != nullptr);
    glfwPollEvents();
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

bool Window::should_close() const {
    return glfwWindowShouldClose(window_) != GLFW_FALSE;
}

void Window::request_close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

glm::ivec2 Window::size_px() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

Framebuffer Window::framebuffer() const {
    const glm::ivec2 size = size_px();
    return Framebuffer::window(size.x, size.y);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::capture_pointer(bool on) {
    glfwSetInputMode(window_, GLFW_CURSOR, on ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

engine::Result<std::unique_ptr<Window>> make_window_context(const WindowOptions& options) {
    std::shared_ptr<void> library = glfw_library();
    if (library == nullptr) return glfw_failure("no window system");

    set_hints(options);
    GLFWwindow* window =
        glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    if (window == nullptr) return glfw_failure("no window with OpenGL 4.5 core");
    NativeContext native = {
        .owner = {window, [library](GLFWwindow* mine) { glfwDestroyWindow(mine); }},
        .make_current = [window] { glfwMakeContextCurrent(window); },
        .platform = "window"};
    native.make_current();
    glfwSwapInterval(options.vsync ? 1 : 0);
    auto context = std::make_unique<Context>(std::move(native), options.context);
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): make_unique cannot reach the constructor
    return std::unique_ptr<Window>(new Window(window, std::move(context)));
}

} // namespace gpu
