#version 450 core
// One rectangle of the screen with the lights that can reach it: a strip of four vertices.

#include "render/include/held_lights.glsl"
#include "render/include/view_ray.glsl"

// Left, bottom, right, top in pixels; the bits of the lights.
layout(location = 0) in uvec4 rectangle;
layout(location = 1) in uint bits;

flat out uint light_bits;
flat out vec3 held_ambient;
flat out vec3 held_background;
#ifdef HELD_LIGHTS
flat out LightData held_lights[HELD_LIGHTS];
#endif
noperspective out vec3 ray; // divided by depth: the position

void main() {
    const uvec2 corners[4] = uvec2[4](uvec2(0, 1), uvec2(2, 1), uvec2(0, 3), uvec2(2, 3));
    uvec2 corner = corners[gl_VertexID];
    vec2 pixel = vec2(rectangle[corner.x], rectangle[corner.y]);
    gl_Position = vec4(pixel / size_near.xy * 2.0 - 1.0, 0.0, 1.0);
    ray = view_ray(pixel) * size_near.z;
    light_bits = bits;
    held_ambient = ambient.rgb;
    held_background = background.rgb;
#ifdef HELD_LIGHTS
    for (int i = 0; i < HELD_LIGHTS; ++i)
        held_lights[i] = lights[i];
#endif
}
