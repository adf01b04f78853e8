// Edges of a caster's outline as they lie on a plane. Read by GLSL and by C++.

#ifndef SHADOWS_SHARED_PLATEAUS_H
#define SHADOWS_SHARED_PLATEAUS_H

#ifdef __cplusplus
#    include <glm/glm.hpp>
namespace shadows {
using glm::vec4;
#endif

#define PLATEAUS_BINDING 3
#define PLATEAU_CONE_SIDES 12
#define PLATEAU_VERTICES (12 + 3 * PLATEAU_CONE_SIDES)

/// On the plane, relative space, metres.
struct PlateauData {
    vec4 from;      ///< shadow of one end
    vec4 to;        ///< shadow of the other
    vec4 side_from; ///< from `from` to where the penumbra beside the edge ends; the other side mirrors it
    vec4 side_to;
    vec4 radius_0; ///< of the penumbra of `from`
    vec4 radius_1;
};

#ifdef __cplusplus
static_assert(sizeof(PlateauData) == 96);
} // namespace shadows
#endif

#endif
