// What was decided for one pair of light and receiver, and why: the common language of picker,
// techniques, plans.json, overlay and `gnomon explain`.

#pragma once

#include "systems/shadows/caster_groups.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shadows {

/// Work of one technique for one pair, as counts. A device profile turns counts into milliseconds.
struct Cost {
    double vertices = 0;
    double depth_fragments = 0;
    double colour_fragments = 0;
    double stencil_fragments = 0;
    double map_texels = 0;
    double taps = 0; ///< look-ups into maps, textures or uploaded masks
    double draws = 0;
    double rays = 0;

    Cost& operator+=(const Cost& other);
};

/// How a technique goes about it, where it has several ways.
struct Variant {
    std::string_view way; ///< a literal that means something to the technique; empty: the usual one
    std::uint16_t samples = 1; ///< points that stand for the light

    bool operator==(const Variant&) const = default;
};

/// What a technique would do for one pair and one group of casters, before it does anything. A
/// plain value.
struct Prediction {
    double error_px = 0.0;      ///< expected edge displacement on screen, pixels
    double error_area_px = 0.0; ///< expected sum of |V - V*| over the screen, pixels
    Cost cost;
    /// Of the groups' casters, one after the other: which of their proxies volumes are made of; 0,
    /// or nothing from here on: of themselves.
    std::vector<std::uint8_t> proxy_levels;
    std::string note; ///< what people should know about it, one clause; mostly empty
    Variant variant;
};

/// One technique at work for some of the casters of a pair.
struct PlanEntry {
    std::string_view technique;               ///< its name, as all techniques keep it
    std::vector<std::uint32_t> caster_groups; ///< indices into the light's groups
    Prediction predicted;                     ///< of all together
    std::vector<Variant> variants = {};       ///< one for each group
};

/// A technique that was not taken.
struct Rejection {
    std::string_view technique; ///< its name, as all techniques keep it
    std::string reason;         ///< one clause: "outside its domain: ...", "dearer", "not pinned"
    std::optional<Prediction> predicted; ///< none when it is outside its domain
};

/// One pair's decision: visibility is the least of the entries'; no entry means fully lit.
struct Plan {
    std::uint32_t light = 0;    ///< id of the light
    std::uint32_t receiver = 0; ///< id of the receiver
    std::vector<PlanEntry> entries;
    std::string reason;     ///< why these entries
    double budget_px = 1.0; ///< the error that was accepted
    std::vector<Rejection> rejected;
};

/// All decisions of a frame.
struct FramePlan {
    /// The casters of one light, in groups.
    struct LightGroups {
        std::uint32_t light = 0;
        std::vector<CasterGroup> groups;
    };
    std::vector<LightGroups> groups; ///< in the order of ShadowScene::lights
    std::vector<Plan> plans;         ///< light by light in that order, receivers in theirs
};

} // namespace shadows
