#include "engine/app/input.hpp"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Key::count)> kNames = {
#define INPUT_KEY(identifier, name, device, code) name,
#include "engine/app/input_keys.def"
#undef INPUT_KEY
};

} // namespace

std::string_view name(Key key) {
    return kNames[static_cast<std::size_t>(key)];
}

std::optional<Key> key_named(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Key>(found - kNames.begin());
}

void Input::advance(const RawInput& raw) {
    before_ = started_ ? now_ : RawInput{.pointer_px = raw.pointer_px};
    now_ = raw;
    started_ = true;
}

float Input::axis(Axis axis) const {
    constexpr float kDeadZone = 0.15F;
    const float value = std::clamp(now_.axes[static_cast<std::size_t>(axis)], -1.0F, 1.0F);
    const float beyond = std::max(std::abs(value) - kDeadZone, 0.0F) / (1.0F - kDeadZone);
    return std::copysign(beyond, value);
}

glm::vec2 Input::walk() const {
    const auto either = [this](Key one, Key other) {
        return down(one) || down(other) ? 1.0F : 0.0F;
    };
    const glm::vec2 keys = {
        either(Key::d, Key::right) - either(Key::a, Key::left),
        either(Key::w, Key::up) - either(Key::s, Key::down)};
    const glm::vec2 wish = keys + glm::vec2(axis(Axis::left_x), axis(Axis::left_y));
    const float length = glm::length(wish);
    return length > 1.0F ? wish / length : wish;
}

RawInput ScriptedInput::take() {
    RawInput raw = raw_;
    raw_.wheel = 0.0F;
    return raw;
}

} // namespace app
