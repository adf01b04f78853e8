// What every pass of a frame knows about its camera. Read by GLSL and by C++.
//
// Positions are relative to the camera ("relative"): the axes of the world, the camera at the origin.
// Depth is reversed and infinite: depth = near / view depth, 0 at infinity.

#ifndef RENDER_SHARED_FRAME_H
#define RENDER_SHARED_FRAME_H

#ifdef __cplusplus
#include <glm/glm.hpp>
namespace render {
using glm::mat4;
using glm::vec4;
#define FRAME_BLOCK struct FrameConstants
#else
#define FRAME_BLOCK layout(std140, binding = FRAME_BINDING) uniform FrameConstants
#endif

#define FRAME_BINDING 0

FRAME_BLOCK {
    mat4 clip_from_relative;
    vec4 ray_corner;  ///< direction through window position (0, 0), view depth 1, relative space
    vec4 ray_per_x;   ///< what one pixel to the right adds
    vec4 ray_per_y;   ///< what one pixel up adds
    vec4 size_near;   ///< width, height in pixels, near distance, 0
};

#ifdef __cplusplus
static_assert(sizeof(FrameConstants) == 128);
} // namespace render
#endif
#undef FRAME_BLOCK

#endif
