#version 450 core
// What receives without casting, where it lies behind a caster.

#include "render/shared/bindings.h"

#ifdef ALPHA_MASKED
in vec2 uv;
flat in vec2 alpha_cutoff;
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color;
#endif
layout(binding = UNIT_DEPTH) uniform sampler2D caster_samples;

void main() {
#ifdef ALPHA_MASKED
    if (textureLod(base_color, uv, 0.0).a * alpha_cutoff.x < alpha_cutoff.y) discard;
#endif
    if (gl_FragCoord.z >= texelFetch(caster_samples, ivec2(gl_FragCoord.xy), 0).r) discard;
}
