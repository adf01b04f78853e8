#version 450 core
// Two triangles that cover the viewport at one depth: the first faces away, the second faces the camera.

uniform float depth;

const vec2 corners[6] = vec2[](
    vec2(-1.0, -1.0), vec2(-1.0, 3.0), vec2(3.0, -1.0),
    vec2(-1.0, -1.0), vec2(3.0, -1.0), vec2(-1.0, 3.0));

void main() {
    gl_Position = vec4(corners[gl_VertexID], depth, 1.0);
}
