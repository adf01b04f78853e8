// What planar shadows would be worth for a pair: their domain, error and cost, and which way of
// drawing them does.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"

#include <array>
#include <string_view>

namespace shadows {

/// Words of Variant::way, and of wishes.
namespace planar_way {
inline constexpr std::string_view kGeometry = "geometry"; ///< casters as they are
inline constexpr std::string_view kBox = "box";           ///< one box in each one's place
inline constexpr std::string_view kBoxes = "boxes";       ///< several
inline constexpr std::string_view kPlateau = "plateau";   ///< a hard shadow with a soft skirt
inline constexpr std::string_view kTexture = "texture";   ///< kept in a texture of the receiver
} // namespace planar_way

inline constexpr std::array kPlanarWays = {
    planar_way::kGeometry,
    planar_way::kBox,
    planar_way::kBoxes,
    planar_way::kPlateau,
    planar_way::kTexture};

/// Of the ways the one that is wished for; else boxes where they are right enough and less to draw,
/// and as many points of the light as the budget needs.
/// Errors: the receiver is not flat; a sun grazes it, so that the shadow has no useful end; the
/// wish is for boxes of casters that have none.
engine::Result<Prediction> predict_planar(const PairView& pair, const CasterGroup& casters);

/// Texels of a kept shadow are as large as that many times the accepted error.
inline constexpr double kKeptTexelPerBudget = 1.0;

/// Whether looking a shadow up is cheaper than projecting it anew.
/// @param projected work for one frame
/// @param area_px where it may be seen
bool keeping_pays(const Cost& projected, double area_px);

} // namespace shadows
