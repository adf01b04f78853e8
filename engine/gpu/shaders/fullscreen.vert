#version 450 core
// One triangle that covers the viewport, at infinite depth; drawn by Frame::draw_fullscreen.

out vec2 position_uv; // 0 at the lower left of the viewport, 1 at the upper right

void main() {
    position_uv = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(position_uv * 2.0 - 1.0, 0.0, 1.0);
}
