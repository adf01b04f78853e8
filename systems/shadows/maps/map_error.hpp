// How wrong a map's edges will be on screen, and how many texels keep them right enough.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

#include <algorithm>
#include <cstdint>

namespace shadows {

enum class MapFilter : std::uint8_t { nearest, bilinear, pcf, pcss };

inline constexpr int kSmallestMap = 256;
inline constexpr int kLargestMap = 4096;
inline constexpr int kPcfWidth = 3; ///< bilinear taps per side of MapFilter::pcf

/// Looks at the light that MapFilter::pcss filters with, and at what may block it on the way.
inline constexpr int kSoftTaps = 32;
constexpr int search_taps(int soft_taps) {
    return std::max(soft_taps / 2, 2);
}
int soft_taps(const scene::ShadowWish& wish);

/// Whether a light has no size: its edges are hard, and MapFilter::pcss has nothing to do.
bool is_hard(const scene::Light& light);

/// How the pair's map is read: as was wished; where nothing was, by the cheapest filter that keeps
/// the budget. Errors: a filter that maps do not have.
/// @param texel_m_of_one as of predict_map()
engine::Result<MapFilter>
map_filter(const PairView& pair, const CasterGroup& casters, double texel_m_of_one);

/// Texels that the filter reads beyond the one it looks up.
int filter_border(MapFilter filter);

/// Texels from a place to the farthest centre that the filter reads, along an axis: FILTER_REACH of
/// map_mask.frag.
double filter_reach(MapFilter filter);

/// Mean error per length of edge, in texels, against a hard shadow. Source: nearest 0.2422,
/// bilinear over 2 x 2 texels 0.332 and 3 x 3 such taps 0.762, isotropic edges over a random grid;
/// see tests/tools/measure/constants_test.cpp.
double edge_error_texels(MapFilter filter);

/// Width of the ramp that the filter makes of a hard edge, in texels.
double ramp_texels(MapFilter filter);

/// The size of a shadow texel as the camera sees it on a receiver, pixels.
/// @param texel_m its size across the light at the receiver, metres
double texel_footprint_px(const PairView& pair, double texel_m);

/// A length across the light at the receiver, as long as the receiver's slant may make it, pixels.
double length_px(const PairView& pair, double across_m);

/// Width of the light's penumbra on the receiver, pixels; 0 for hard lights.
double penumbra_px(const PairView& pair, const CasterGroup& casters);

/// What a map would do for a pair. Errors: those of map_filter().
/// @param texel_m_of_one texel size at the receiver of a map with a single texel per side, metres
/// @param layers of the map that the pair's light needs
engine::Result<Prediction>
predict_map(const PairView& pair, const CasterGroup& casters, double texel_m_of_one, int layers);

/// Texels per side: what was asked for, else the least power of two that keeps the pair's budget.
int map_size_for(
    const PairView& pair, const CasterGroup& casters, MapFilter filter, double texel_m_of_one);

} // namespace shadows
