#version 450 core
// Visibility by looking into a shadow map, for the receivers of its plans.
//
// PARALLEL with MAP_LAYERS cascades, SPOT, or CUBE; a filter of map_filter.glsl; EVERY_RECEIVER where the job serves
// them all.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/include/map_inputs.glsl"
#include "shadows/include/map_place.glsl"
#include "shadows/include/map_filter.glsl"
#ifndef EVERY_RECEIVER
#include "shadows/include/receivers.glsl"
#endif

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
layout(binding = UNIT_FACETS) uniform usampler2D facets;
layout(binding = UNIT_DEPTH) uniform sampler2D depth_buffer;

noperspective in vec3 ray;
flat in MapInputs map;

layout(location = 0) out float visibility;

#ifdef PARALLEL
// Texels between a place and the nearest border that filters may not pass; negative outside.
float depth_inside(MapInputs map, vec4 placement, vec2 texel) {
    vec2 inside = min(texel, map.size.x - texel) - map.size.w - map.source.x * placement.xy;
    return min(inside.x, inside.y);
}

float light_at(MapInputs map, Receiver receiver) {
    Across seen = across_light(map, receiver);
    const int LAST = MAP_LAYERS - 1;
    vec4 placement = map.placement[LAST];
    vec4 next_placement = placement;
    float layer = float(LAST);
    float inside = depth_inside(map, placement, texel_in(seen, placement));
    for (int finer = LAST - 1; finer >= 0; --finer) {
        float inside_finer = depth_inside(map, map.placement[finer], texel_in(seen, map.placement[finer]));
        bool better = inside_finer >= 0.0;
        next_placement = better ? placement : next_placement;
        placement = better ? map.placement[finer] : placement;
        layer = better ? float(finer) : layer;
        inside = better ? inside_finer : inside;
    }
    float lit = light_through(place_parallel(map, receiver, seen, placement, layer), map.size.y);
#ifndef SUDDEN_SEAMS
    // The last tenth of a cascade fades into the next.
    float share = inside / (0.1 * map.size.x);
    if (share < 1.0 && layer < float(LAST))
        lit = mix(
            light_through(place_parallel(map, receiver, seen, next_placement, layer + 1.0), map.size.y),
            lit,
            max(share, 0.0));
#endif
    return lit;
}
#endif

#ifdef SPOT
float light_at(MapInputs map, Receiver receiver) {
    Receiver seen = from_light(map, receiver);
    if (seen.point.z <= 0.0) return 1.0;
    return light_through(place_pyramid(map, seen, 0.0), map.size.y);
}
#endif

#ifdef CUBE
// The axis that leads is forward; the other two follow in turn. shadows::cube_views lays its faces alike.
// @param leading 0 x, 1 y, 2 z
vec3 face_axes(vec3 v, int leading, float side) {
    vec3 turned = leading == 0 ? v : leading == 1 ? v.yzx : v.zxy;
    return vec3(-side * turned.y, turned.z, side * turned.x);
}

float light_at(MapInputs map, Receiver receiver) {
    Receiver seen = from_light(map, receiver);
    vec3 size = abs(seen.point);
    int leading = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    float side = sign(leading == 0 ? seen.point.x : leading == 1 ? seen.point.y : seen.point.z);
    seen = Receiver(
        face_axes(seen.point, leading, side),
        face_axes(seen.normal, leading, side),
        seen.unknown_texels);
    float face = float(2 * leading) + (side > 0.0 ? 0.0 : 1.0);
    return light_through(place_pyramid(map, seen, face), map.size.y);
}
#endif

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
#ifdef GUESSED_FACETS
    facet = cross(dFdx(point), dFdy(point));
    if (dot(facet, point) > 0.0) facet = -facet; // the side that is seen
#endif
    Receiver receiver = receiver_at(point, facet, shaded, to_light);
    // What is turned away gets no light of this lamp, whatever the map says.
    visibility = dot(receiver.normal, to_light) > 0.0 ? light_at(map, receiver) : 0.0;
#ifdef EVERY_RECEIVER
    if (id == 0u) visibility = 1.0;
#else
    if (!serves(id)) visibility = 1.0;
#endif
}
