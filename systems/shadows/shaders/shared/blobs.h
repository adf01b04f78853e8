// Blobs of one light. Read by GLSL and by C++.

#ifndef SHADOWS_SHARED_BLOBS_H
#define SHADOWS_SHARED_BLOBS_H

#ifdef __cplusplus
#    include <glm/glm.hpp>
namespace shadows {
using glm::uvec4;
using glm::vec4;
#endif

#define BLOBS_BINDING 1

/// The space "unit" has the blob as its unit sphere.
struct BlobData {
    vec4 row_0; ///< rows of unit_from_relative
    vec4 row_1;
    vec4 row_2;
    vec4 light; ///< of a sun: its way in unit space, 0; of a lamp: minus its place in unit space, 1
    vec4 rectangle; ///< left, bottom, right, top, pixels
    vec4 plane;     ///< what a quad would lie on, relative space; of tests alone
    uvec4 own; ///< receiver ids of the caster itself, first and end; softness as a float; 0
};

#ifdef __cplusplus
static_assert(sizeof(BlobData) == 112);
} // namespace shadows
#endif

#endif
