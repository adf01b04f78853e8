#version 450 core
// Casters as a light sees them.

#include "render/include/transform.glsl"

uniform mat4 map_clip_from_relative; // relative to the origin of this map's instances
#ifdef ALPHA_MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv_mesh;
layout(location = ATTRIBUTE_SURFACE) in uvec4 surface;
out vec2 uv;
flat out vec2 alpha_cutoff;
#endif

void main() {
    gl_Position = map_clip_from_relative * vec4(relative_position(position_mesh), 1.0);
#ifdef VERTEX_PANCAKING
    gl_Position.z = min(gl_Position.z, gl_Position.w);
#endif
#ifdef ALPHA_MASKED
    uv = uv_mesh;
    alpha_cutoff = uintBitsToFloat(surface.zw);
#endif
}
