// How lights reach a pixel: a few as flat inputs, many from the block. Rasterisers that run on a CPU check and fetch
// every read of a block for every pixel; a flat input costs them one broadcast per triangle.

#include "render/shared/lights.h"

#if DIRECTIONAL_COUNT <= 1 && LOCAL_COUNT <= 2 && DIRECTIONAL_COUNT + LOCAL_COUNT > 0
#define HELD_LIGHTS (DIRECTIONAL_COUNT + LOCAL_COUNT)
#define LIGHT(i) held_lights[i]
#else
#define LIGHT(i) lights[i]
#endif
