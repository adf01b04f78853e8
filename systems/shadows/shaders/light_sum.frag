#version 450 core
// What of a light's points is not blocked. See techniques/light_sum.hpp.

#include "render/shared/bindings.h"
#include "shadows/shared/receivers.h"

layout(binding = UNIT_VISIBILITY) uniform sampler2D sum; // blocked, given

layout(location = 0) out float visibility;

void main() {
    vec2 light = texelFetch(sum, ivec2(gl_FragCoord.xy), 0).rg;
    visibility = light.g > 0.0 ? 1.0 - light.r / light.g : 1.0;
}
