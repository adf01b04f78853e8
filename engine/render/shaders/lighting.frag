#version 450 core
// All lights of a batch times their masks, plus what earlier batches left; the last batch tone maps.

#include "render/shared/bindings.h"
#include "render/shared/lights.h"
#include "render/include/gbuffer.glsl"
#include "render/include/position.glsl"
#include "render/include/tone_map.glsl"

layout(binding = UNIT_GBUFFER) uniform usampler2D gbuffer;
#ifdef LOCAL_LIGHTS
layout(binding = UNIT_DEPTH) uniform sampler2D depth_buffer;
#endif
#ifdef MASKS
layout(binding = UNIT_MASKS) uniform sampler2DArray masks;
#endif
#ifdef ADD_EARLIER
layout(binding = UNIT_LIGHT) uniform sampler2D earlier_light;
#endif

flat in uint light_bits;
layout(location = 0) out vec4 color;

// Exposed light of lights[index] on a surface at `position` with `normal`, before albedo.
vec3 light_on(int index, vec3 position, vec3 normal) {
    LightData light = lights[index];
    vec3 to_light = -light.direction_layer.xyz;
    float strength = 1.0;
#ifdef LOCAL_LIGHTS
    // Source: KHR_lights_punctual, range and cone attenuation; scene::illuminance_at is its twin on the CPU.
    if (light.position_kind.w != LIGHT_DIRECTIONAL) {
        vec3 offset = light.position_kind.xyz - position;
        float distance_2 = max(dot(offset, offset), 1e-8);
        to_light = offset * inversesqrt(distance_2);
        float window = clamp(1.0 - distance_2 * distance_2 * light.color_range.w, 0.0, 1.0);
        float cone = clamp(dot(-to_light, light.direction_layer.xyz) * light.cone.x + light.cone.y, 0.0, 1.0);
        strength = window / distance_2 * cone * cone;
    }
#endif
    strength *= max(dot(normal, to_light), 0.0);
#ifdef MASKS
    if (light.direction_layer.w != NO_MASK_LAYER)
        strength *= texelFetch(masks, ivec3(gl_FragCoord.xy, int(light.direction_layer.w)), 0).r;
#endif
    return light.color_range.rgb * strength;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 surface = texelFetch(gbuffer, pixel, 0).xy;
    vec3 light = background.rgb;
    if (surface_receiver(surface) != 0u) {
        vec3 normal = surface_normal(surface);
        vec3 position = vec3(0.0);
#ifdef LOCAL_LIGHTS
        position = position_from_depth(texelFetch(depth_buffer, pixel, 0).r);
#endif
        vec3 arriving = ambient.rgb;
        for (uint bits = light_bits; bits != 0u; bits &= bits - 1u)
            arriving += light_on(findLSB(bits), position, normal);
        light = arriving * unpack_albedo(surface.y);
    }
#ifdef ADD_EARLIER
    light += texelFetch(earlier_light, pixel, 0).rgb;
#endif
#ifdef TONE_MAP
    color = vec4(encode_srgb(tone_map(light)), 1.0);
#else
    color = vec4(light, 1.0);
#endif
}
