#version 450 core
// How much of a light an ellipsoid hides from what a pixel shows, seen as a soft ellipse.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "shadows/include/receivers.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
layout(binding = UNIT_DEPTH) uniform sampler2D depth;

noperspective in vec3 ray;
flat in vec4 row_0;
flat in vec4 row_1;
flat in vec4 row_2;
flat in vec4 light;
flat in vec4 plane;
flat in uvec2 own;
flat in float softness;

layout(location = 0) out float visibility;

const float EDGE_GROWTH = 0.25; // of a hard light's edge, per radius behind the blob
const float EDGE_LEAST = 1e-3;  // in radii, for a division

// The part of a light of some width that is hidden behind a disc of radius 1.
// @param distance_to_axis of the point's way to the light from the disc's centre
// @param edge half the width of the penumbra; over 1 the light looks larger than the disc
float coverage(float distance_to_axis, float edge) {
    float ramp = clamp((1.0 + edge - distance_to_axis) / (2.0 * edge), 0.0, 1.0);
    return ramp / max(1.0, edge * edge);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint receiver = surface_receiver(texelFetch(gbuffer, pixel, 0).xy);
    if (!serves(receiver) || (receiver >= own.x && receiver < own.y)) discard;
    vec4 place = vec4(ray / texelFetch(depth, pixel, 0).r, 1.0);
#ifdef ON_PLANE
    // A quad on the first receiver's plane, whatever lies there, for tests.
    place.xyz = ray * (-plane.w / dot(plane.xyz, ray));
#endif
    vec3 place_unit = vec3(dot(row_0, place), dot(row_1, place), dot(row_2, place));
    vec3 along = light.w * place_unit + light.xyz; // the way of the light
    float behind = dot(place_unit, along) / dot(along, along); // of a sun: metres; of a lamp: part of the way
    if (behind <= 0.0) discard;
    float distance_to_axis = length(place_unit - behind * along);
    // Where the shadow begins, at the ellipsoid's rim, its edge has no width yet.
    float grown = min(BLOB_EDGE, EDGE_GROWTH * behind * length(along));
    visibility = 1.0 - coverage(distance_to_axis, max(max(grown, softness * behind), EDGE_LEAST));
}
