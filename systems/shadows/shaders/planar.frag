#version 450 core
// One value, where the caster has no hole.

#include "render/shared/bindings.h"

#ifdef ALPHA_MASKED
in vec2 uv;
flat in vec2 alpha_cutoff;
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color;
#endif

uniform float value; // 0 for darkness at once; where samples are summed up, what one of them adds

layout(location = 0) out float written;

void main() {
#ifdef ALPHA_MASKED
    // Holes are decided on the full picture, as in the G-buffer and truth.
    if (textureLod(base_color, uv, 0.0).a * alpha_cutoff.x < alpha_cutoff.y) discard;
#endif
    written = value;
}
