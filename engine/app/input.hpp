// What the player's hands do, as plain values per frame. A device (or a script) gives one RawInput
// a frame; Input compares it with the one before.

#pragma once

#include <glm/glm.hpp>

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

namespace app {

/// Keys by their place on a US keyboard, and the mouse's buttons.
/// One row each in input_keys.def.
enum class Key : std::uint8_t {
#define INPUT_KEY(identifier, name, device, code) identifier,
#include "engine/app/input_keys.def"
#undef INPUT_KEY
    count,
};

/// "w", "space", "left_shift", "mouse_left", "f12", "pad_a": as scripts write it.
std::string_view name(Key key);
std::optional<Key> key_named(std::string_view name);

using Keys = std::bitset<static_cast<std::size_t>(Key::count)>;

/// Axes of a gamepad. Sticks in [-1, 1], x right, y up; triggers in [0, 1].
enum class Axis : std::uint8_t {
    left_x,
    left_y,
    right_x,
    right_y,
    left_trigger,
    right_trigger,
    count
};

/// The state of all devices at one moment.
struct RawInput {
    Keys down = {};
    glm::vec2 pointer_px = glm::vec2(0.0F); ///< from the top left of the window
    float wheel = 0.0F;                     ///< notches since the last frame, up is positive
    std::array<float, static_cast<std::size_t>(Axis::count)> axes = {};
};

/// One frame of input.
class Input {
public:
    /// Starts the next frame.
    void advance(const RawInput& raw);

    [[nodiscard]] bool down(Key key) const { return now_.down[index(key)]; }
    [[nodiscard]] bool pressed(Key key) const { return down(key) && !before_.down[index(key)]; }
    [[nodiscard]] bool released(Key key) const { return !down(key) && before_.down[index(key)]; }

    [[nodiscard]] glm::vec2 pointer_px() const { return now_.pointer_px; }
    /// Since the last frame, y down; zero in the first.
    [[nodiscard]] glm::vec2 pointer_delta_px() const {
        return now_.pointer_px - before_.pointer_px;
    }
    [[nodiscard]] float wheel() const { return now_.wheel; }

    /// With a dead zone of 0.15 at rest, then rising from 0.
    [[nodiscard]] float axis(Axis axis) const;

    /// Where the player wants to go: W A S D, arrows or the left stick, x right, y forward, length
    /// at most 1.
    [[nodiscard]] glm::vec2 walk() const;

private:
    static std::size_t index(Key key) { return static_cast<std::size_t>(key); }

    RawInput now_;
    RawInput before_;
    bool started_ = false;
};

/// Hands that a script moves.
class ScriptedInput {
public:
    void press(Key key) { raw_.down.set(static_cast<std::size_t>(key)); }
    void release(Key key) { raw_.down.reset(static_cast<std::size_t>(key)); }
    void release_all() { raw_.down.reset(); }
    void move_pointer(const glm::vec2& position_px) { raw_.pointer_px = position_px; }
    void turn_wheel(float notches) { raw_.wheel += notches; }
    void tilt(Axis axis, float value) { raw_.axes[static_cast<std::size_t>(axis)] = value; }

    /// The state for the next frame. The wheel starts again from zero.
    RawInput take();

private:
    RawInput raw_;
};

} // namespace app
