// What keeps known failures away. Everything is always on; only a test turns one off, to see the
// failure that it prevents.

#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>

namespace shadows {

/// One row each in remedies.def.
enum class Remedy : std::uint8_t {
#define SHADOW_REMEDY(name, about) name,
#include "systems/shadows/remedies.def"
#undef SHADOW_REMEDY
    count,
};

/// Its spelling in remedies.def. @pre a remedy, not `count`
constexpr std::string_view name_of(Remedy remedy) {
    constexpr std::array kNames = {
#define SHADOW_REMEDY(name, about) std::string_view(#name),
#include "systems/shadows/remedies.def"
#undef SHADOW_REMEDY
    };
    return kNames[static_cast<std::size_t>(remedy)];
}

/// A value: all on when default constructed.
class Remedies {
public:
    [[nodiscard]] bool on(Remedy remedy) const { return !off_[static_cast<std::size_t>(remedy)]; }
    [[nodiscard]] Remedies without(Remedy remedy) const {
        Remedies fewer = *this;
        fewer.off_.set(static_cast<std::size_t>(remedy));
        return fewer;
    }

    bool operator==(const Remedies&) const = default;

private:
    std::bitset<static_cast<std::size_t>(Remedy::count)> off_;
};

} // namespace shadows
