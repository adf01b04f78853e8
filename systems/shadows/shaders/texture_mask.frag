#version 450 core
// Dark behind the casters of one texture, for the receivers of its plans. SUMMED for one point of a light with a size,
// see techniques/light_sum.hpp.
//
// PARALLEL or SPOT, with MAP_LAYERS 1. An edge is where half is covered, so it stays a line however near the camera
// comes. Source: C. Green, "Improved Alpha-Tested Magnification for Vector Textures and Special Effects", 2007.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/include/light_given.glsl"
#include "shadows/include/map_inputs.glsl"
#include "shadows/include/map_place.glsl"
#include "shadows/include/receivers.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
layout(binding = UNIT_FACETS) uniform usampler2D facets;
layout(binding = UNIT_DEPTH) uniform sampler2D depth_buffer;
layout(binding = UNIT_VISIBILITY) uniform sampler2D texels; // as texture_reduce.frag writes them

noperspective in vec3 ray;
flat in MapInputs map;

#ifdef SUMMED
layout(location = 0) out float light; // blocked
#else
layout(location = 0) out float visibility;
#endif

// No surface that still takes light to speak of rises more than 16 texels' depth within one: what is so much nearer
// blocks, whatever a plane seen edge on says.
const float STEEPEST = 16.0 / CREASE_TANGENT;

// The share of a texel that blocks light from the receiver's plane.
float blocked(MapPlace at, vec2 centre) {
    ivec2 size = ivec2(map.size.x);
    ivec2 texel = ivec2(floor(centre));
#ifdef CLAMPED
    texel = clamp(texel, ivec2(0), size - 1);
#else
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) return 0.0;
#endif
    vec4 seen = texelFetch(texels, texel, 0);
#ifdef ANYWHERE
    float before = 1.0;
#else
    // Where shading turns away before the surface does, the two say nothing about each other.
    float unknown = at.rise + abs(at.slope.x) + abs(at.slope.y);
    float plane = at.depth + min(dot(at.slope, centre - at.texel) + min(at.slack, unknown), STEEPEST * at.rise);
    // What of the texel is nearer than the plane, were the rest at the plane itself.
    float before = seen.y > plane ? clamp((seen.z - plane) / (seen.y - plane), 0.0, 1.0) : 0.0;
#ifdef ONE_DEPTH
    before = step(at.depth, seen.y);
#endif
#if defined(CAUGHT) && !defined(BACKWARD)
    if (seen.w > 0.0 && seen.w > plane + unknown) return 0.0;
#endif
#endif
    return seen.x * before;
}

float darkness(MapPlace at) {
#ifdef BLOCKS
    return blocked(at, floor(at.texel) + 0.5);
#else
    vec2 first = floor(at.texel - 0.5) + 0.5;
    vec2 part = at.texel - first;
    vec2 left = vec2(blocked(at, first), blocked(at, first + vec2(0.0, 1.0)));
    vec2 right = vec2(blocked(at, first + vec2(1.0, 0.0)), blocked(at, first + vec2(1.0, 1.0)));
    vec2 rows = mix(left, right, part.x);
    return mix(rows.x, rows.y, part.y);
#endif
}

bool dark(Receiver receiver) {
#ifdef PARALLEL
    Across seen = across_light(map, receiver);
    return darkness(place_parallel(map, receiver, seen, map.placement[0], 0.0)) >= 0.5;
#else
    Receiver seen = from_light(map, receiver);
#ifndef BACKWARD
    if (seen.point.z <= 0.0) return false;
#endif
    return darkness(place_pyramid(map, seen, 0.0)) >= 0.5;
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 surface = texelFetch(gbuffer, pixel, 0).xy;
    uint id = surface_receiver(surface);
    vec3 point = ray / texelFetch(depth_buffer, pixel, 0).r;
#ifdef PARALLEL
    vec3 to_light = -map.along;
#else
    vec3 to_light = map.light - point;
#endif
    vec3 shaded = surface_direction(surface);
    vec3 facet = facet_direction(texelFetch(facets, pixel, 0).r);
    Receiver receiver = receiver_at(point, facet, shaded, to_light);
    bool blocked = serves(id) && dot(receiver.normal, to_light) > 0.0 && dark(receiver);
#ifdef SUMMED
    if (!blocked) discard;
    light = given_by(facet, shaded, to_light);
#else
    visibility = blocked ? 0.0 : 1.0;
#endif
}
