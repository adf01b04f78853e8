#version 450 core
// What of the light is left where its samples' shadows were summed up.

#include "shadows/shared/receivers.h"

layout(binding = UNIT_VISIBILITY) uniform sampler2D blocked;

layout(location = 0) out float visibility;

void main() {
    visibility = 1.0 - texelFetch(blocked, ivec2(gl_FragCoord.xy), 0).r;
}
