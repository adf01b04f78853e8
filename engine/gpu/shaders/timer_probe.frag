#version 450 core
// Work that takes as long as one asks, and that no compiler can leave out.

uniform int iterations;

in vec2 position_uv;
layout(location = 0) out float result;

void main() {
    float value = position_uv.x + position_uv.y;
    for (int i = 0; i < iterations; ++i) value = fract(value * 1.37 + 0.1);
    result = value;
}
