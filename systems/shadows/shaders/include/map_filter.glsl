// Reads a map: how much of the light passes at a place.
//
// FILTER_NEAREST, FILTER_BILINEAR (2 x 2 texels), FILTER_PCF: the mean of PCF_WIDTH x PCF_WIDTH bilinear taps, or
// FILTER_PCSS: as wide as the light's penumbra, see map_soft.glsl.

#include "render/shared/bindings.h"
#include "shadows/shared/receivers.h"

layout(binding = UNIT_VISIBILITY) uniform sampler2DArray shadow_map;

// What is nearer to the light at a point of the map blocks: the depth of the receiver's plane there, and how far a wall
// may stand before it.
float plane_depth(MapPlace at, vec2 texel) {
#ifdef FLAT_DEPTH
    return at.depth;
#elif defined(BIAS_OF_ONE_TEXEL)
    return at.depth + 0.5 * (abs(at.slope.x) + abs(at.slope.y)) + at.slack;
#else
    vec2 away = texel - at.texel;
    float depth = at.depth + dot(at.slope, away) + at.slack;
#ifndef CLOSED_CREASES
    depth += at.rise * (abs(away.x) + abs(away.y));
#endif
    return depth;
#endif
}

// What a map keeps of a depth.
vec4 kept(vec4 depth) {
#ifdef DEPTH_STEPS
    return round(depth * DEPTH_STEPS) / DEPTH_STEPS;
#else
    return depth;
#endif
}

// 1 where the light passes four texels whose lower left one has its centre at `texel`. Lower left, lower right, upper
// left, upper right.
// @param stored what the map holds there
vec4 passes_at(MapPlace at, vec2 texel, vec4 stored) {
    vec4 receiver = vec4(
        plane_depth(at, texel),
        plane_depth(at, texel + vec2(1.0, 0.0)),
        plane_depth(at, texel + vec2(0.0, 1.0)),
        plane_depth(at, texel + vec2(1.0, 1.0)));
    return step(kept(stored), receiver);
}

#ifdef FILTER_PCSS
#include "shadows/include/map_soft.glsl"
#else
vec4 passes(MapPlace at, vec2 texel, float per_map) {
    return passes_at(at, texel, textureGather(shadow_map, vec3((texel + 0.5) * per_map, at.layer)).wzxy);
}

// @param per_map one over the texels per side
float light_through(MapPlace at, float per_map) {
#ifdef FILTER_NEAREST
    vec2 centre = floor(at.texel) + 0.5;
    float stored = textureLod(shadow_map, vec3(centre * per_map, at.layer), 0.0).r;
    return step(kept(vec4(stored)).x, plane_depth(at, centre));
#else
    vec2 first = floor(at.texel - 0.5) + 0.5;
    vec2 part = at.texel - first;
#ifdef FILTER_BILINEAR
    vec4 lit = passes(at, first, per_map);
    vec2 row = mix(lit.xz, lit.yw, part.x);
    return mix(row.x, row.y, part.y);
#else
    const int REACH = PCF_WIDTH / 2; // texels before the first of the middle tap
    float sum = 0.0;
    for (int y = -REACH; y <= REACH; y += 2) {
        for (int x = -REACH; x <= REACH; x += 2) {
            vec4 lit = passes(at, first + vec2(x, y), per_map);
            vec4 weights = vec4(1.0);
            if (x == -REACH) weights.xz *= 1.0 - part.x;
            if (x + 1 == REACH + 1) weights.yw *= part.x;
            if (y == -REACH) weights.xy *= 1.0 - part.y;
            if (y + 1 == REACH + 1) weights.zw *= part.y;
            sum += dot(lit, weights);
        }
    }
    return sum / float(PCF_WIDTH * PCF_WIDTH);
#endif
#endif
}
#endif
