#version 450 core
// Four samples of what a light sees become one texel: the share that casters cover, their nearest depth, their mean
// depth, and the depth of what catches their shadow first.

#include "render/shared/bindings.h"
#include "shadows/shared/receivers.h"

layout(binding = UNIT_DEPTH) uniform sampler2D caster_samples;
#ifdef CAUGHT
layout(binding = UNIT_VISIBILITY) uniform sampler2D catcher_samples;
#endif

layout(location = 0) out vec4 texel;

void main() {
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(textureSize(caster_samples, 0)); // where four samples meet
    vec4 depths = textureGather(caster_samples, place);
    float covered = dot(vec4(greaterThan(depths, vec4(0.0))), vec4(1.0));
    float nearest = max(max(depths.x, depths.y), max(depths.z, depths.w));
    float mean = dot(depths, vec4(1.0)) / max(covered, 1.0);
    float caught = 0.0;
#ifdef CAUGHT
    vec4 catchers = textureGather(catcher_samples, place);
    caught = max(max(catchers.x, catchers.y), max(catchers.z, catchers.w));
#endif
    texel = vec4(0.25 * covered, nearest, mean, caught);
}
