#include "engine/app/window_input.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <utility>

namespace app {

namespace {

enum class Device : std::uint8_t { keyboard, mouse, pad };

struct KeyCode {
    Device device;
    int code;
};

constexpr std::array<KeyCode, static_cast<std::size_t>(Key::count)> kCodes = {{
#define INPUT_KEY(identifier, name, device, code) {Device::device, GLFW_##code},
#include "engine/app/input_keys.def"
#undef INPUT_KEY
}};

bool is_down(GLFWwindow* window, const GLFWgamepadstate& pad, const KeyCode& key) {
    switch (key.device) {
    case Device::keyboard:
        return glfwGetKey(window, key.code) == GLFW_PRESS;
    case Device::mouse:
        return glfwGetMouseButton(window, key.code) == GLFW_PRESS;
    case Device::pad:
        return pad.buttons[key.code] == GLFW_PRESS;
    }
    return false;
}

/// GLFW's sticks point down where y is positive, and its triggers rest at -1.
std::array<float, static_cast<std::size_t>(Axis::count)> axes_of(const GLFWgamepadstate& pad) {
    const auto trigger = [&pad](int axis) { return (pad.axes[axis] + 1.0F) * 0.5F; };
    return {
        pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X],
        -pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y],
        pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X],
        -pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y],
        trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER),
        trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER)};
}

} // namespace

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetScrollCallback(window, &WindowInput::on_scroll);
    glfwSetCursorEnterCallback(window, &WindowInput::on_enter);
    glfwSetInputMode(window, GLFW_STICKY_KEYS, GLFW_TRUE);
    glfwSetInputMode(window, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE);
}

WindowInput::~WindowInput() {
    glfwSetScrollCallback(window_, nullptr);
    glfwSetCursorEnterCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

void WindowInput::on_scroll(GLFWwindow* window, double /*x*/, double y) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->wheel_ += static_cast<float>(y);
}

void WindowInput::on_enter(GLFWwindow* window, int /*entered*/) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->entered_ = true;
}

/// GLFW 3.3 takes a captured pointer that comes into the window (back from another one, or because
/// the window shrank) for one that was moved there, which would turn the view.
glm::dvec2 WindowInput::pointer() {
    glm::dvec2 now(0.0);
    glfwGetCursorPos(window_, &now.x, &now.y);
    const bool captured = glfwGetInputMode(window_, GLFW_CURSOR) == GLFW_CURSOR_DISABLED;
    const bool entered = std::exchange(entered_, false);
    if (!captured) not_moved_ = glm::dvec2(0.0);
    if (captured && entered) not_moved_ += now - before_;
    before_ = now;
    return now - not_moved_;
}

RawInput WindowInput::take() {
    GLFWgamepadstate pad = {};
    const bool has_pad = glfwGetGamepadState(GLFW_JOYSTICK_1, &pad) == GLFW_TRUE;

    RawInput raw;
    for (std::size_t i = 0; i < kCodes.size(); ++i)
        raw.down[i] = is_down(window_, pad, kCodes[i]);
    int width = 0;
    int width_px = 0;
    glfwGetWindowSize(window_, &width, nullptr);
    glfwGetFramebufferSize(window_, &width_px, nullptr);
    const double px_per_unit = width > 0 ? static_cast<double>(width_px) / width : 1.0;
    raw.pointer_px = glm::vec2(pointer() * px_per_unit);
    raw.wheel = std::exchange(wheel_, 0.0F);
    if (has_pad) raw.axes = axes_of(pad);
    return raw;
}

} // namespace app
