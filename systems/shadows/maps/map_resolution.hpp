// What one texel of a map is on a surface, and what that is on screen.

#pragma once

#include "engine/scene/camera.hpp"
#include "systems/shadows/maps/map_view.hpp"
#include "systems/shadows/resolution.hpp"

namespace shadows {

/// A texel thrown along the light onto the plane of a surface.
struct TexelOnSurface {
    glm::dvec3 right = {}; ///< along the plane to where the next texel to the right falls, metres
    glm::dvec3 up = {};    ///< the same upward
    glm::dvec3 ray = {};   ///< the way the light travels, of length 1 along the map's view
    double depth_unknown = 0.0; ///< metres along the map's view that the look-up forgives
};

/// @param reach texels that the filter reads to each side, see filter_reach()
/// @pre the surface is turned to the light
TexelOnSurface texel_at(const ParallelView& view, const SurfacePoint& point, double reach);
TexelOnSurface texel_at(const PyramidView& view, const SurfacePoint& point, double reach);

/// The larger singular value of the step from texels to pixels; and how far apart on screen the
/// surface and the same surface nearer to the light by the unknown depth are: where a caster stands
/// on its receiver, its shadow begins that much too late.
/// @pre the point lies before the camera
/// Source: D. B. Lloyd et al., "Warping and Partitioning for Low Error Shadow Maps", 2006 (texels
/// projected into the image).
Resolution
on_screen(const scene::CameraView& camera, const SurfacePoint& point, const TexelOnSurface& texel);

} // namespace shadows
