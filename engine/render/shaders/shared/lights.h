// The lights of one lighting batch. Read by GLSL and by C++.

#ifndef RENDER_SHARED_LIGHTS_H
#define RENDER_SHARED_LIGHTS_H

#ifdef __cplusplus
#include <glm/glm.hpp>
namespace render {
using glm::vec4;
#define LIGHTS_BLOCK struct LightConstants
#else
#define LIGHTS_BLOCK layout(std140, binding = LIGHTS_BINDING) uniform LightConstants
#endif

#define LIGHTS_BINDING 1
#define MAX_BATCH_LIGHTS 32
#define MAX_MASK_LAYERS 8
#define LIGHT_DIRECTIONAL 0.0f
#define LIGHT_SPOT 1.0f
#define LIGHT_POINT 2.0f
#define NO_MASK_LAYER -1.0f

struct LightData {
    vec4 position_kind;   ///< relative position, LIGHT_...
    vec4 direction_layer; ///< unit, the way the light travels; layer of its mask, or NO_MASK_LAYER
    vec4 color_range;     ///< exposed color over pi; 1 / range^4 (0: endless)
    vec4 cone;            ///< scale and offset of the cone's fall-off, 0, 0
};

LIGHTS_BLOCK {
    vec4 ambient;    ///< rgb
    vec4 background; ///< rgb of pixels that show nothing, linear
    LightData lights[MAX_BATCH_LIGHTS];
};

#ifdef __cplusplus
static_assert(sizeof(LightData) == 64);
static_assert(sizeof(LightConstants) == 32 + 64 * MAX_BATCH_LIGHTS);
} // namespace render
#endif
#undef LIGHTS_BLOCK

#endif
