#version 450 core
// One rectangle of the screen per blob, with the way from the camera to what each pixel shows.

#include "render/include/view_ray.glsl"
#include "shadows/shared/blobs.h"

layout(std430, binding = BLOBS_BINDING) readonly buffer Blobs {
    BlobData blobs[];
};

noperspective out vec3 ray; // divided by depth: the position, relative space
flat out vec4 row_0;
flat out vec4 row_1;
flat out vec4 row_2;
flat out vec4 light;
flat out vec4 plane;
flat out uvec2 own;
flat out float softness;

void main() {
    BlobData blob = blobs[gl_InstanceID];
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    vec2 window = mix(blob.rectangle.xy, blob.rectangle.zw, corner);
    gl_Position = vec4(window / size_near.xy * 2.0 - 1.0, 0.0, 1.0);
    ray = view_ray(window) * size_near.z;
    row_0 = blob.row_0;
    row_1 = blob.row_1;
    row_2 = blob.row_2;
    light = blob.light;
    plane = blob.plane;
    own = blob.own.xy;
    softness = uintBitsToFloat(blob.own.z);
}
