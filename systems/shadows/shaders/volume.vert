#version 450 core
// The corners of shadow volumes: vertices of their casters, each where the G-buffer has it, or as far from the light as
// light goes.

#include "render/include/transform.glsl"
#include "shadows/shared/receivers.h"

layout(std430, binding = VOLUME_POSITIONS_BINDING) readonly buffer Positions {
    float coordinates[]; // three for each vertex
};

uniform vec4 light_mesh; // where the light comes from: a place and 1, or the way to the light and 0

#ifdef FINITE
const float REACH = 10.0; // metres that a naive volume is long
#endif
#ifdef FAR_PLANE
const float FAR = 12.0; // metres to a plane that is no farther than what is seen
#endif
#ifdef WORLD_SPACE
uniform vec3 eye;
#endif

vec4 near_corner(vec3 point) {
#ifdef WORLD_SPACE
    // What rounds when corners are computed in the world.
    precise vec3 place = relative_position(point) + eye;
    return clip_from_relative * vec4(place - eye, 1.0);
#else
    return clip_position(point);
#endif
}

vec4 far_corner(vec3 point) {
    vec3 away_mesh = point * light_mesh.w - light_mesh.xyz;
    vec3 away = vec3(dot(row_0.xyz, away_mesh), dot(row_1.xyz, away_mesh), dot(row_2.xyz, away_mesh));
#ifdef FINITE
    return clip_from_relative * vec4(relative_position(point) + normalize(away) * REACH, 1.0);
#else
    return clip_from_relative * vec4(away, 0.0);
#endif
}

void main() {
    int first = 3 * (gl_VertexID >> 1);
    vec3 point = vec3(coordinates[first], coordinates[first + 1], coordinates[first + 2]);
    bool near = (gl_VertexID & 1) == 0;
    gl_Position = near ? near_corner(point) : far_corner(point);
#ifdef FAR_PLANE
    gl_ClipDistance[0] = (near ? FAR : 0.0) - gl_Position.w; // w is the depth along the view, of a point or of a way
#endif
}
