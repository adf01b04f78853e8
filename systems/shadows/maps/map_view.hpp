// A map as a square of texels that a light sees, and how large one texel is on a receiver. Pure
// arithmetic in doubles: nothing here knows how maps are drawn or read.
//
// Map space: x and y in [0, 1] over the map, z its depth: 1 nearest to the light, 0 farthest, as
// everywhere.

#pragma once

#include <glm/glm.hpp>

namespace shadows {

/// The rotation with these rows: a light's right, up and the way it looks.
glm::dmat3 axes_from_rows(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& forward);

/// One layer of a map of a directional light: a box of parallel rays.
struct ParallelView {
    glm::dmat3 light_from_world = glm::dmat3(1.0); ///< rows: right, up, the way the light travels
    glm::dvec2 min = {};                           ///< lower left corner, metres along right and up
    glm::dvec2 texel = {};                         ///< metres
    int size = 0;                                  ///< texels per side
    double nearest = 0.0;                          ///< metres along the light where depth is 1
    double farthest = 1.0;                         ///< and where it is 0

    [[nodiscard]] glm::dmat4 map_from_world() const;
    /// Right, up and along the light, metres.
    [[nodiscard]] glm::dvec3 light_from(const glm::dvec3& point) const {
        return light_from_world * point;
    }
};

/// One layer of a map of a spot or point light: a pyramid of rays from a point. Depth is infinite
/// and reversed: near / distance along the view.
struct PyramidView {
    glm::dvec3 position = {};
    glm::dmat3 light_from_world = glm::dmat3(1.0); ///< rows: right, up, forward
    glm::dvec2 min = glm::dvec2(-1.0); ///< the window's corners: right and up over forward
    glm::dvec2 max = glm::dvec2(1.0);
    int size = 0;
    double near = 0.001; ///< metres

    [[nodiscard]] glm::dmat4 map_from_world() const;
};

/// What both kinds turn into for drawing: clip space with depth as above.
glm::dmat4 clip_from_map();

} // namespace shadows
