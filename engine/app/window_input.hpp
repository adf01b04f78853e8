// The keyboard, mouse and first gamepad of a window.

#pragma once

#include "engine/app/input.hpp"

struct GLFWwindow;

namespace app {

/// Reads a window's devices. Takes the window's scroll callback and user pointer; a panel that is
/// installed later must pass callbacks on, as Dear ImGui does.
class WindowInput {
public:
    /// @param window must outlive this
    explicit WindowInput(GLFWwindow* window);
    ~WindowInput();
    WindowInput(const WindowInput&) = delete;
    WindowInput& operator=(const WindowInput&) = delete;
    WindowInput(WindowInput&&) = delete;
    WindowInput& operator=(WindowInput&&) = delete;

    /// The state after the window's last poll(). A key tapped between two polls is down for one
    /// frame.
    RawInput take();

private:
    static void on_scroll(GLFWwindow* window, double x, double y);

    GLFWwindow* window_;
    float wheel_ = 0.0F;
};

} // namespace app
