#version 450 core

#include "render/shared/bindings.h"
#include "render/include/gbuffer.glsl"

in vec3 point_relative; // from the camera
in vec3 normal_relative;
flat in uvec4 instance_surface;
#ifdef TEXTURED
in vec2 uv;
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color;
#endif

layout(location = 0) out uvec2 packed_surface;
layout(location = 1) out uint packed_facet;

void main() {
    uint packed_albedo = instance_surface.y;
#ifdef TEXTURED
    vec4 texel = texture(base_color, uv);
#ifdef ALPHA_MASKED
    // Holes are decided on the full picture, as in maps and truth: smaller ones would close or widen them.
    float alpha = textureLod(base_color, uv, 0.0).a * uintBitsToFloat(instance_surface.z);
    if (alpha < uintBitsToFloat(instance_surface.w)) discard;
#endif
    packed_albedo = pack_albedo(unpack_albedo(packed_albedo) * texel.rgb);
#endif
    vec3 normal = normal_relative;
#ifdef DOUBLE_SIDED
    if (!gl_FrontFacing) normal = -normal;
#endif
    packed_surface = pack_surface(instance_surface.x, normal, packed_albedo);
    // Inside a triangle the change of position is exact, also where the next pixel shows another one.
    vec3 facet = cross(dFdx(point_relative), dFdy(point_relative));
    packed_facet = pack_facet(dot(facet, point_relative) > 0.0 ? -facet : facet);
}
