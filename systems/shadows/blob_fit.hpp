// A blob: the ellipsoid inside a caster's box, whose shadow stands for the caster's. Everything
// about it happens in the space in which the ellipsoid is the unit sphere: a point is in its shadow
// when the way to the light passes the centre at less than 1. Low suns, the growth of shadows away
// from lamps, elongated casters and receivers of any shape need nothing else.

#pragma once

#include "systems/shadows/shadow_scene.hpp"

namespace shadows {

struct Blob {
    glm::dvec3 centre = {};                       ///< world space
    glm::dmat3 unit_from_world = glm::dmat3(1.0); ///< turns and scales, relative to the centre
};

/// The ellipsoid inside the caster's box. Boxes without a thickness get a little of one.
Blob fit_blob(const CasterView& caster);

/// A sphere in its place whose shadow is as large, seen from the light.
Blob round_blob(const Blob& blob, const LightView& light);

/// Radius of the disc as large as the ellipsoid seen from the light, metres.
/// Source: the ellipsoid with unit_from_world = M shows the area pi |M d| / |det M| along a unit d.
double disc_radius(const Blob& blob, const LightView& light);

/// The way of the light through a point, unit length.
glm::dvec3 light_direction(const LightView& light, const glm::dvec3& point);

/// A box round everything inside `receiver` that a caster's box, grown by its blob's soft edge, can
/// darken. Conservative; empty when there is nothing.
engine::WorldAabb swept_bounds(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver);

/// Half the width that a hard light's edge grows to, in radii of the blob: blobs are soft, as their
/// outline is a guess.
inline constexpr double kBlobEdge = 0.125;

} // namespace shadows
