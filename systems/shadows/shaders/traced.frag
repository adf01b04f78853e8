#version 450 core
// Visibility from the truth tracer, as uploaded, for the receivers of its plans.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/include/receivers.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
layout(binding = UNIT_VISIBILITY) uniform sampler2D traced_visibility;

layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint receiver = surface_receiver(texelFetch(gbuffer, pixel, 0).xy);
    visibility = serves(receiver) ? texelFetch(traced_visibility, pixel, 0).r : 1.0;
}
