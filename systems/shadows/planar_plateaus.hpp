// Plateaus: a hard shadow with a skirt of half shade round it. Every edge of the caster's outline
// becomes a slope on the plane, every corner a cone, as wide as the penumbra that the light throws
// from that height; where they overlap the darkest counts.
//
// The umbra keeps the size of the hard shadow: all of the penumbra lies outside, so a shadow is too
// large by a quarter of the penumbra's width per length of edge, and an umbra that should vanish
// stays black. Source: E. Haines, "Soft Planar Shadows Using Plateaus", jgt 6(1), 2001.

#pragma once

#include "systems/shadows/planar_projection.hpp"
#include "systems/shadows/volumes/caster_surface.hpp"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace shadows {

/// An edge of an outline as it lies on the plane, metres.
struct PlateauEdge {
    glm::dvec3 from = {}; ///< shadow of one end
    glm::dvec3 to = {};
    glm::dvec3 side_from = {}; ///< from `from` to where the penumbra beside the edge ends; the
                               ///< other side mirrors it
    glm::dvec3 side_to = {};
    glm::dvec3 radius_0 = {}; ///< of the penumbra of `from`
    glm::dvec3 radius_1 = {};
};

/// The skirt of a caster's shadow. Edges under the plane or beyond the light are left out or cut.
/// @param positions one per vertex of the surface's mesh, as posed
/// @param origin what the result is relative to, world space
/// Cost: one look at every triangle and edge.
std::vector<PlateauEdge> plateau_edges(
    const LightView& light,
    const LitPlane& plane,
    const CasterSurface& surface,
    std::span<const glm::vec3> positions,
    const glm::dmat4& world_from_mesh,
    const glm::dvec3& origin);

/// How the penumbra of a point lies on the plane: an ellipse, by two radii that need not be at
/// right angles. First order in the light's size. World space, metres.
/// @pre least_height <= height of the point <= most_height
struct PenumbraEllipse {
    glm::dvec3 centre = {};
    glm::dvec3 radius_0 = {};
    glm::dvec3 radius_1 = {};
};
PenumbraEllipse
penumbra_ellipse(const LightView& light, const LitPlane& plane, const glm::dvec3& point);

} // namespace shadows
