// The keyboard, mouse and first gamepad of a window.

#pragma once

#include "engine/app/input.hpp"

struct GLFWwindow;

namespace app {

/// Reads a window's devices. Takes the window's callbacks for scrolling and entering, and its user
/// pointer; a panel that is installed later must pass callbacks on, as Dear ImGui does.
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
    static void on_enter(GLFWwindow* window, int entered);
    glm::dvec2 pointer();

    GLFWwindow* window_;
    float wheel_ = 0.0F;
    bool entered_ = false;                   ///< since the last take()
    glm::dvec2 before_ = glm::dvec2(0.0);    ///< GLFW's pointer at the last take(), screen units
    glm::dvec2 not_moved_ = glm::dvec2(0.0); ///< its jumps so far that no hand made
};

} // namespace app
