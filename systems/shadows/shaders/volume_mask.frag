#version 450 core
// Dark, where the stencil lets it be and the job serves the receiver.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/include/receivers.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;

layout(location = 0) out float visibility;

void main() {
    uint receiver = surface_receiver(texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0).xy);
    // No discard: what is let through also loses its count.
    visibility = serves(receiver) ? 0.0 : 1.0;
}
