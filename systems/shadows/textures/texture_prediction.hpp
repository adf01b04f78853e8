// What shadow textures would be worth for a pair: their domain, error, cost, and texels.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

namespace shadows {

inline constexpr int kSmallestTexture = 16;
inline constexpr int kLargestTexture = 1024;
/// Samples per side of a texel, from which its coverage is counted.
inline constexpr int kSamplesPerSide = 2;

/// Mean error per length of edge, in texels, where coverage is one half: 0.073 for straight edges,
/// 0.09 for discs of two texels' radius. Held by tests/systems/shadows/textures.
inline constexpr double kTextureEdgeTexels = 0.09;

/// Errors: a lamp amid its casters, or so close to them that no texture holds them.
engine::Result<Prediction> predict_texture(const PairView& pair, const CasterGroup& casters);

/// What a group's textures are made of.
struct TextureLayout {
    int size = kSmallestTexture; ///< texels per side
    int samples = 1;             ///< points of the light, a texture each

    bool operator==(const TextureLayout&) const = default;
};

/// How many textures of a size are kept: 64 MiB.
int most_samples(int size);

/// What serves two receivers.
TextureLayout finer(const TextureLayout& a, const TextureLayout& b);

/// What was asked for; else one texture where a hard edge keeps the pair's budget, or as many
/// points of the light as do; and the least power of two of texels that keeps it where the shadow
/// falls.
/// @pre predict_texture() does not refuse
TextureLayout texture_layout(const PairView& pair, const CasterGroup& casters);

} // namespace shadows
