// How good a picture can be: an error below these means nothing, or too much.

#pragma once

namespace measure {

/// Mean share of pixels that change when an edge moves by d px in a random direction: (2 / pi) d
/// per px of edge, since only the part of the step across the edge counts, and the mean of |cos| is
/// 2 / pi.
inline constexpr double kMeanAcross = 0.63661977;

/// A shift of 1/16 px: what rasterisers and tracers disagree by.
inline constexpr double kPrecisionFloor = kMeanAcross / 16.0;
/// A shift of 1/2 px: what one sample per pixel cannot tell.
inline constexpr double kHalfPixelFloor = kMeanAcross / 2.0;
/// Two independent truths of 1024 jittered light samples, per px of penumbra width: 0.35 x
/// 1024^-0.75. Source of the exponent: Mitchell, "Consequences of Stratified Sampling in Graphics",
/// 1996.
inline constexpr double kSamplingFloor = 0.002;

/// Shorter edges give no meaningful error per px of edge.
inline constexpr double kMinEdgePx = 32.0;

inline constexpr double kMaxInvalidShare = 0.02;
inline constexpr double kMaxUndecidedShare = 0.005;
/// A picture whose pixels lie closer to edges than its texels are wide proves nothing.
inline constexpr double kMaxBandShare = 0.25;
/// Double darkening: darker than the reference by more than two steps of an 8-bit picture.
inline constexpr float kDarkerThanReference = 2.0F / 255.0F;

} // namespace measure
