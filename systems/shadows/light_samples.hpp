// A light with a size as a number of points: soft shadows are sums of hard ones.
//
// Truth sees a shining sphere, or the sun, as a cone of directions that all count the same. So the
// points fill the disc of this cone as seen from one place, spread evenly over its solid angle. A
// lamp's points also lie before and behind this disc, so that they fill an even disc from wherever
// they are seen: evenly spread over the sphere in four dimensions, whose shadow on any plane is a
// disc that is even again.
//
// Sources: R. Cook, "Stochastic Sampling in Computer Graphics", 1986 (jitter); J. Hammersley,
// "Monte Carlo Methods for Solving Multivariable Problems", 1960; P. Shirley and K. Chiu, "A Low
// Distortion Map Between Disk and Square", 1997.

#pragma once

#include "systems/shadows/shadow_scene.hpp"

#include <cstdint>
#include <vector>

namespace shadows {

/// How points lie in a square. Regular ones fall in line with edges and make bands of them.
enum class SamplePattern : std::uint8_t { regular, jittered, hammersley };

/// Points of the unit square [0, 1) x [0, 1): the same ones for the same numbers. Of the patterns
/// with strata any count is stratified: rows have their share of the height.
/// @pre count > 0
std::vector<glm::dvec2> square_samples(SamplePattern pattern, int count);

/// Area onto area: the unit square onto the unit disc, with little distortion.
glm::dvec2 disc_from_square(const glm::dvec2& square);

/// Whether the light is larger than a point.
bool has_size(const LightView& light);

/// Lights without a size that stand for one with a size, each as bright as the others.
/// @param seen_from where the shadow falls, world space
/// @return the light itself where it has no size, or one sample is asked for
std::vector<LightView> light_samples(
    const LightView& light, const glm::dvec3& seen_from, int count, SamplePattern pattern);

/// Lights without a size round a light with one: their convex hull holds the light.
std::vector<LightView> light_outline(const LightView& light, const glm::dvec3& seen_from);

/// What N points are expected to be wrong by, per length of edge: this times the penumbra's width.
/// Source: simulated for edges in all directions, 0.35 N^-0.75 for jittered points.
double sampling_error(int count);

/// The least of 4, 8, 16 ... kMostSamples points whose error is accepted, 1 where no penumbra is
/// seen; kMostSamples where none is.
/// @param penumbra_px width
/// @param accepted_px per length of edge
int samples_for(double penumbra_px, double accepted_px);

inline constexpr int kFewestSamples = 4;
inline constexpr int kMostSamples = 128;

} // namespace shadows
