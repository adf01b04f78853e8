#version 450 core
// One rectangle of the screen with the lights that can reach it: a strip of four vertices.

#include "render/shared/frame.h"

// Left, bottom, right, top in pixels; the bits of the lights.
layout(location = 0) in uvec4 rectangle;
layout(location = 1) in uint bits;

flat out uint light_bits;

void main() {
    const uvec2 corners[4] = uvec2[4](uvec2(0, 1), uvec2(2, 1), uvec2(0, 3), uvec2(2, 3));
    uvec2 corner = corners[gl_VertexID];
    vec2 at = vec2(rectangle[corner.x], rectangle[corner.y]) / size_near.xy;
    gl_Position = vec4(at * 2.0 - 1.0, 0.0, 1.0);
    light_bits = bits;
}
