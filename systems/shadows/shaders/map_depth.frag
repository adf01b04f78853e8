#version 450 core
// Depth alone; holes of alpha-masked materials are left open.

#ifdef ALPHA_MASKED
#include "render/shared/bindings.h"
in vec2 uv;
flat in vec2 alpha_cutoff; // of the base color; below which there is a hole
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color;
#endif

void main() {
#ifdef ALPHA_MASKED
    if (textureLod(base_color, uv, 0.0).a * alpha_cutoff.x < alpha_cutoff.y) discard;
#endif
}
