#version 450 core
// What of the light is left on one flat receiver, whose shadow lies in a texture of its plane.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/shared/receivers.h"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
layout(binding = UNIT_DEPTH) uniform sampler2D depth_buffer;
layout(binding = UNIT_VISIBILITY) uniform sampler2D blocked; // the part of the light

uniform uint receiver;
uniform vec4 across; // with the camera's own place in w: 0 to 1 over the texture
uniform vec4 along;

noperspective in vec3 ray;

layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (surface_receiver(texelFetch(gbuffer, pixel, 0).xy) != receiver) discard;
    vec3 point = ray / texelFetch(depth_buffer, pixel, 0).r;
    vec2 place = vec2(dot(across.xyz, point) + across.w, dot(along.xyz, point) + along.w);
    visibility = 1.0 - textureLod(blocked, place, 0.0).r;
}
