// The views of maps of spot and point lights.

#pragma once

#include "systems/shadows/maps/map_view.hpp"
#include "systems/shadows/shadow_scene.hpp"

#include <array>
#include <span>

namespace shadows {

/// A spot wider than this is the business of a cube map: the texels in its middle grow with the
/// tangent of the angle.
inline constexpr double kWidestSpot = 1.0471975511965976; // 60 degrees each side

/// The part of the cone in which something casts: nothing else needs texels.
/// @param casters bounds of everything that casts
/// @param size texels per side
/// @param border texels that filters may read beyond the window
/// @param reach how far penumbrae may reach beyond it: right and up over forward
PyramidView spot_view(
    const LightView& light,
    std::span<const engine::WorldAabb> casters,
    int size,
    int border,
    double reach = 0.0);

/// The axes of a cube of views, as rows. People build along x, y and z; were texels to lie in rows
/// along the same axes, whole edges of shadows would be off by up to half a texel, and no filter
/// could tell. Across the rows, errors change sign from texel to texel and filters take their mean.
glm::dmat3 cube_turn();

/// Six views with square openings, in the order +x, -x, +y, -y, +z, -z of cube_turn(). Each sees
/// `reach` and `border` texels more than a quarter turn, so that filters never look past an edge
/// into nothing.
std::array<PyramidView, 6>
cube_views(const glm::dvec3& position, int size, int border, double reach = 0.0);

/// Whether anything in a box can be seen by a view. Conservative.
bool sees(const PyramidView& view, const engine::WorldAabb& box);

} // namespace shadows
