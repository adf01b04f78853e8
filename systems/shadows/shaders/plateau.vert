#version 450 core
// The skirt of one edge of an outline: a slope to each side of it, and a cone round its first end.

#include "render/shared/bindings.h"
#include "shadows/shared/plateaus.h"

layout(std430, binding = PLATEAUS_BINDING) readonly buffer Plateaus {
    PlateauData edges[];
};

uniform mat4 clip_from_origin;
uniform int first_edge;

out float dark; // 1 at the edge, 0 where the penumbra ends

const float TURN = 6.28318530718;

// Corners of two triangles: along the edge from `from` to `to`, away from it 0 or 1.
const ivec2 slope[6] = ivec2[](
    ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));

vec3 cone_point(PlateauData edge, int vertex) {
    int corner = vertex % 3;
    dark = corner == 0 ? 1.0 : 0.0;
    if (corner == 0) return edge.from.xyz;
    float turn = TURN * float(vertex / 3 + corner - 1) / float(PLATEAU_CONE_SIDES);
    return edge.from.xyz + cos(turn) * edge.radius_0.xyz + sin(turn) * edge.radius_1.xyz;
}

vec3 slope_point(PlateauData edge, int vertex) {
    ivec2 at = slope[vertex % 6];
    float side = vertex < 6 ? 1.0 : -1.0;
    dark = 1.0 - float(at.y);
    vec3 start = at.x == 0 ? edge.from.xyz : edge.to.xyz;
    vec3 away = at.x == 0 ? edge.side_from.xyz : edge.side_to.xyz;
    return start + side * float(at.y) * away;
}

void main() {
    PlateauData edge = edges[first_edge + gl_InstanceID];
    vec3 point = gl_VertexID < 12 ? slope_point(edge, gl_VertexID) : cone_point(edge, gl_VertexID - 12);
    gl_Position = clip_from_origin * vec4(point, 1.0);
}
