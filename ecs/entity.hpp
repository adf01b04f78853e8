// An entity is a number: an index that is used again after the entity dies, and a generation that
// is not.

#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace ecs {

/// 20 bits of index (a million entities), 12 bits of generation. The default value names no entity.
struct Entity {
    static constexpr std::uint32_t kIndexBits = 20;
    static constexpr std::uint32_t kIndexMask = (1U << kIndexBits) - 1U;

    std::uint32_t value = 0xFFFFFFFFU;

    [[nodiscard]] constexpr std::uint32_t index() const { return value & kIndexMask; }
    [[nodiscard]] constexpr std::uint32_t generation() const { return value >> kIndexBits; }
    static constexpr Entity from(std::uint32_t index, std::uint32_t generation) {
        return {(generation << kIndexBits) | index};
    }
    constexpr auto operator<=>(const Entity&) const = default;
};

inline constexpr Entity kNoEntity{};

} // namespace ecs

template <>
struct std::hash<ecs::Entity> {
    std::size_t operator()(ecs::Entity entity) const noexcept {
        return std::hash<std::uint32_t>()(entity.value);
    }
};
