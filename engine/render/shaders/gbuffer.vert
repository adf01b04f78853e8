#version 450 core
// Geometry, once per view.

#include "render/include/transform.glsl"

layout(location = ATTRIBUTE_NORMAL) in vec4 normal_mesh;
layout(location = ATTRIBUTE_PATCH) in uint patch_id;
// Receiver id of patch 0, packed base color (square root encoded), alpha of the base color and cutoff as floats.
layout(location = ATTRIBUTE_SURFACE) in uvec4 surface;

out vec3 point_relative;
out vec3 normal_relative;
flat out uvec4 instance_surface;
#ifdef TEXTURED
layout(location = ATTRIBUTE_UV) in vec2 uv_mesh;
out vec2 uv;
#endif

void main() {
    gl_Position = clip_position(position_mesh);
    point_relative = relative_position(position_mesh);
    normal_relative = relative_normal(normal_mesh.xyz);
    instance_surface = surface;
    bool without_patches = (surface.x & SURFACE_WITHOUT_PATCHES) != 0u;
    instance_surface.x = (surface.x & ~SURFACE_WITHOUT_PATCHES) + (without_patches ? 0u : patch_id);
#ifdef TEXTURED
    uv = uv_mesh;
#endif
}
