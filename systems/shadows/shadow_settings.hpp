// What designers asked of shadows, and how several wishes for one pair become one.

#pragma once

#include "engine/scene/description.hpp"
#include "engine/scene/light.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shadows {

/// Budgets and pins of a level. Later wins: scene, light, receiver, rules in their order, then the
/// overriding one.
struct ShadowSettings {
    scene::ShadowWish scene;
    std::map<std::string, scene::ShadowWish, std::less<>> lights;    ///< by the light's name
    std::map<std::string, scene::ShadowWish, std::less<>> receivers; ///< by the model's name
    std::vector<scene::RuleDescription> rules;
    /// The command line or the tuning panel, by the light's kind.
    std::map<scene::LightKind, scene::ShadowWish> overriding;

    static ShadowSettings from(const scene::SceneDescription& description);

    /// The wishes for one pair, one on top of the other. Fields nobody set stay empty.
    /// @param receiver name of a receiver; its patches ("floor#2") and nodes ("hero/arm") follow
    /// their model ("floor")
    /// @param distance from the camera to the receiver, metres
    [[nodiscard]] scene::ShadowWish
    resolve(const scene::PlacedLight& light, std::string_view receiver, double distance) const;

    bool operator==(const ShadowSettings&) const = default;
};

/// The accepted error where nobody set one, in pixels of edge displacement.
inline constexpr double kDefaultBudgetPx = 1.0;
/// The same for heroes.
inline constexpr double kHeroBudgetPx = 0.25;

} // namespace shadows
