#version 450 core
// A caster's points where their shadows lie on a plane. The projection stays homogeneous to the end, so that points
// that near the light's height go to infinity instead of flipping round.

#include "render/include/transform.glsl"

uniform mat4 clip_from_caster; // from positions as instances have them, through the plane
uniform vec4 height_plane;     // height over the plane = dot(height_plane, point)
uniform vec2 height_range;     // what lies between is drawn: neither the receiver itself nor what is beyond the light
uniform float depth_offset;    // 0, but where a test shows what offsets do
uniform float per_light_height; // 1 / the light's own height, 0 for a sun

out float gl_ClipDistance[2];
#ifdef ALPHA_MASKED
layout(location = ATTRIBUTE_UV) in vec2 uv_mesh;
layout(location = ATTRIBUTE_SURFACE) in uvec4 surface; // in z and w: alpha of the base color, cutoff
out vec2 uv;
flat out vec2 alpha_cutoff;
#endif

void main() {
    vec4 point = vec4(relative_position(position_mesh), 1.0);
    float height = dot(height_plane, point);
    gl_ClipDistance[0] = height - height_range.x;
    gl_ClipDistance[1] = height_range.y - height;
    gl_Position = clip_from_caster * point;
#ifdef EARLY_DIVISION
    // What a projection to points does, for tests: beyond the light it gives a mirrored shadow.
    gl_Position /= 1.0 - height * per_light_height;
#endif
    gl_Position.z += depth_offset * gl_Position.w;
#ifdef ALPHA_MASKED
    uv = uv_mesh;
    alpha_cutoff = uintBitsToFloat(surface.zw);
#endif
}
