#version 450 core
// All lights of a batch times their masks, plus what earlier batches left; the last batch tone maps.
//
// DIRECTIONAL_COUNT lights come first in the block, LOCAL_COUNT spots and points behind them. A few lights are written
// out: constant indices are far cheaper than a loop on rasterisers that run on a CPU.

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"
#include "render/include/held_lights.glsl"
#include "render/include/tone_map.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
#if LOCAL_COUNT > 0
layout(binding = UNIT_DEPTH) uniform sampler2D depth_buffer;
#endif
#ifdef MASKS
layout(binding = UNIT_MASKS) uniform sampler2DArray masks;
#endif
#ifdef ADD_EARLIER
layout(binding = UNIT_LIGHT) uniform sampler2D earlier_light;
#endif

flat in uint light_bits;
flat in vec3 held_ambient;
flat in vec3 held_background;
#ifdef HELD_LIGHTS
flat in LightData held_lights[HELD_LIGHTS];
#endif
noperspective in vec3 ray;
layout(location = 0) out vec4 color;

float visibility_of(LightData light) {
#ifdef MASKS
    if (light.direction_layer.w != NO_MASK_LAYER)
        return texelFetch(masks, ivec3(gl_FragCoord.xy, int(light.direction_layer.w)), 0).r;
#endif
    return 1.0;
}

// Exposed light on a surface before albedo, for a normal of any length.
vec3 directional_light(LightData light, vec3 normal, float normal_2) {
    float cosine = max(-dot(normal, light.direction_layer.xyz), 0.0) * inversesqrt(normal_2);
    return light.color_range.rgb * (cosine * visibility_of(light));
}

// Source: KHR_lights_punctual, range and cone attenuation; scene::illuminance_at is its twin on the CPU.
vec3 local_light(LightData light, vec3 position, vec3 normal, float normal_2) {
    vec3 offset = light.position_kind.xyz - position;
    float distance_2 = max(dot(offset, offset), 1e-4);
    float window = clamp(1.0 - distance_2 * distance_2 * light.color_range.w, 0.0, 1.0);
    // Cosine over squared distance, with one division.
    float cosine_falloff = max(dot(normal, offset), 0.0) / (sqrt(normal_2 * distance_2) * distance_2);
    float strength = window * cosine_falloff * visibility_of(light);
#ifdef SPOTS
    float cos_angle = -dot(offset, light.direction_layer.xyz) * inversesqrt(distance_2);
    float cone = clamp(cos_angle * light.cone.x + light.cone.y, 0.0, 1.0);
    strength *= cone * cone;
#endif
    return light.color_range.rgb * strength;
}

#define ADD_DIRECTIONAL(i) arriving += directional_light(LIGHT(i), normal, normal_2);
#define ADD_LOCAL(i) arriving += local_light(LIGHT(i), position, normal, normal_2);

vec3 light_arriving(vec3 position, vec3 normal) {
    vec3 arriving = held_ambient;
    float normal_2 = dot(normal, normal);
#if DIRECTIONAL_COUNT > 0
    ADD_DIRECTIONAL(0)
#endif
#if DIRECTIONAL_COUNT > 1
    for (int i = 1; i < DIRECTIONAL_COUNT; ++i)
        ADD_DIRECTIONAL(i)
#endif
#if LOCAL_COUNT == 1
    ADD_LOCAL(DIRECTIONAL_COUNT)
#elif LOCAL_COUNT == 2
    ADD_LOCAL(DIRECTIONAL_COUNT)
    ADD_LOCAL(DIRECTIONAL_COUNT + 1)
#elif LOCAL_COUNT > 2
    for (uint bits = light_bits >> DIRECTIONAL_COUNT; bits != 0u; bits &= bits - 1u)
        ADD_LOCAL(DIRECTIONAL_COUNT + findLSB(bits))
#endif
    return arriving;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 surface = texelFetch(gbuffer, pixel, 0).xy;
    vec3 position = vec3(0.0);
#if LOCAL_COUNT > 0
    position = ray / texelFetch(depth_buffer, pixel, 0).r;
#endif
    vec3 shown = light_arriving(position, surface_direction(surface)) * unpack_albedo(surface.y);
    vec3 light = surface_receiver(surface) != 0u ? shown : held_background;
#ifdef ADD_EARLIER
    light += texelFetch(earlier_light, pixel, 0).rgb;
#endif
#ifdef TONE_MAP
    color = vec4(display_color(light), 1.0);
#else
    color = vec4(light, 1.0);
#endif
}
