#version 450 core
// What of a light's points is not blocked. See techniques/light_sum.hpp.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/include/light_given.glsl"
#include "shadows/shared/receivers.h"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
layout(binding = UNIT_FACETS) uniform usampler2D facets;
layout(binding = UNIT_DEPTH) uniform sampler2D depth_buffer;
layout(binding = UNIT_VISIBILITY) uniform sampler2D blocked;

uniform vec4 points[POINTS]; // relative to the camera; with w = 0 directions to the light

noperspective in vec3 ray;

layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float sum = texelFetch(blocked, pixel, 0).r;
    visibility = 1.0;
    if (sum == 0.0) return;
    vec3 point = ray / texelFetch(depth_buffer, pixel, 0).r;
    vec3 facet = facet_direction(texelFetch(facets, pixel, 0).r);
    vec3 shaded = surface_direction(texelFetch(gbuffer, pixel, 0).xy);
    float given = 0.0;
    for (int i = 0; i < POINTS; ++i)
        given += given_by(facet, shaded, points[i].xyz - points[i].w * point);
    visibility = 1.0 - sum / given;
}
