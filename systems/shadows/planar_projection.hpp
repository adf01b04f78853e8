// Shadows on planes as projections: a caster's points go along the light onto the receiver's plane
// by one homogeneous matrix. Between two heights the projection is right: what lies under the plane
// throws no shadow on it, and neither does what lies beyond the light, although the matrix would
// put a mirrored shadow of it on the other side.
//
// Source: J. Blinn, "Me and My (Fake) Shadow", IEEE CG&A, 1988; P. Heckbert and M. Herf,
// "Simulating Soft Shadows with Graphics Hardware", CMU-CS-97-104, 1997.

#pragma once

#include "systems/shadows/shadow_scene.hpp"

#include <optional>

namespace shadows {

/// The plane of a flat receiver, its normal on the lit side. World space.
struct LitPlane {
    glm::dvec3 normal = {0.0, 1.0, 0.0};
    double offset = 0.0;
    double least_height = 0.0; ///< lower than this is the receiver itself, metres
    double light_height = 0.0; ///< infinite for a sun

    /// Higher than this is beyond the light, or so near to its height that shadows have no end.
    [[nodiscard]] double most_height() const;
    [[nodiscard]] double height(const glm::dvec3& point) const {
        return glm::dot(normal, point) - offset;
    }
};

/// None when no light falls on it: the light is behind the plane, or in it.
/// @param origin where positions are counted from when they are drawn; rounding grows with the
/// distance from it, and with it the height under which a point counts as the plane's own
/// @pre receiver.flat
std::optional<LitPlane>
lit_plane(const LightView& light, const ReceiverView& receiver, const glm::dvec3& origin);

/// The matrix that takes a point, relative to `origin`, to its shadow on the plane, relative to
/// `origin`. Points between the plane and the light have a shadow with w > 0.
/// @pre the light is not in the plane
glm::dmat4
shadow_from_caster(const LightView& light, const LitPlane& plane, const glm::dvec3& origin);

/// A box round the shadow that a box throws on a receiver: empty when it throws none.
/// Conservative.
engine::WorldAabb shadow_bounds(
    const LightView& light,
    const LitPlane& plane,
    const ReceiverView& receiver,
    const engine::WorldAabb& caster);

/// The sine of the angle between the light and the plane, where the light falls on `point`.
double sine_of_elevation(const LightView& light, const LitPlane& plane, const glm::dvec3& point);

} // namespace shadows
