#version 450 core
// Lets the stencil mark the pixels that show one receiver.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
uniform uint receiver;

void main() {
    if (surface_receiver(texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0).xy) != receiver) discard;
}
