// The one way from mesh space to the screen. Every pass that must meet the G-buffer's depth bit for bit
// (volumes, planar shadows, maps of the camera) includes this and nothing else.

#include "render/shared/bindings.h"
#include "render/shared/frame.h"

layout(location = ATTRIBUTE_POSITION) in vec3 position_mesh;
// Rows of the affine matrix relative_from_mesh of this instance.
layout(location = ATTRIBUTE_ROW_0) in vec4 row_0;
layout(location = ATTRIBUTE_ROW_1) in vec4 row_1;
layout(location = ATTRIBUTE_ROW_2) in vec4 row_2;

invariant gl_Position;

vec3 relative_position(vec3 point_mesh) {
    vec4 point = vec4(point_mesh, 1.0);
    return vec3(dot(row_0, point), dot(row_1, point), dot(row_2, point));
}

vec4 clip_position(vec3 point_mesh) {
    return clip_from_relative * vec4(relative_position(point_mesh), 1.0);
}

// The cofactors of the matrix turn normals rightly under any scale; the sign undoes mirroring. Not normalised.
vec3 relative_normal(vec3 normal_mesh) {
    vec3 cofactor_0 = cross(row_1.xyz, row_2.xyz);
    vec3 cofactor_1 = cross(row_2.xyz, row_0.xyz);
    vec3 cofactor_2 = cross(row_0.xyz, row_1.xyz);
    float side = dot(row_0.xyz, cofactor_0) < 0.0 ? -1.0 : 1.0;
    return side * vec3(dot(cofactor_0, normal_mesh), dot(cofactor_1, normal_mesh), dot(cofactor_2, normal_mesh));
}
