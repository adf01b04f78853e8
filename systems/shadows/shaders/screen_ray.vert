#version 450 core
// One triangle over the viewport, with the way from the camera to what each pixel shows.

#include "render/include/view_ray.glsl"

noperspective out vec3 ray; // divided by depth: the position, relative space

void main() {
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2)); // in viewports
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
    ray = view_ray(corner * size_near.xy) * size_near.z;
}
