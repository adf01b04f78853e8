// The packed G-buffer, 64 bits a pixel: 20 of receiver id, 2 x 10 of normal, 3 x 8 of albedo (square root encoded).
// A receiver id of 0 is a pixel that shows nothing. Beside it lies the normal of the triangle itself, towards the
// camera, in 2 x 16 bits: shadows fall on triangles, light on the smooth surface that they stand for.

const uint RECEIVER_BITS = 20u;
const uint RECEIVER_MASK = (1u << RECEIVER_BITS) - 1u;

// Octahedral map of the sphere. Source: Cigolle et al., "A Survey of Efficient Representations for Independent Unit
// Vectors", JCGT 2014. Any length but zero will do.
vec2 octahedral(vec3 normal) {
    vec2 flat_part = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    vec2 folded = (1.0 - abs(flat_part.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(flat_part, vec2(0.0)));
    return normal.z >= 0.0 ? flat_part : folded;
}

// Not normalised. @param point each coordinate in [-scale, scale]
vec3 from_octahedral(vec2 point, float scale) {
    vec3 normal = vec3(point, scale - abs(point.x) - abs(point.y));
    float fold = max(-normal.z, 0.0);
    normal.x -= normal.x >= 0.0 ? fold : -fold;
    normal.y -= normal.y >= 0.0 ? fold : -fold;
    return normal;
}

uint pack_albedo(vec3 albedo) {
    uvec3 bytes = uvec3(sqrt(clamp(albedo, 0.0, 1.0)) * 255.0 + 0.5);
    return bytes.r | (bytes.g << 8) | (bytes.b << 16);
}

vec3 unpack_albedo(uint packed_albedo) {
    vec3 root = vec3(packed_albedo & 0xFFu, (packed_albedo >> 8) & 0xFFu, (packed_albedo >> 16) & 0xFFu) * (1.0 / 255.0);
    return root * root;
}

uvec2 pack_surface(uint receiver, vec3 normal, uint packed_albedo) {
    uvec2 bits = uvec2(octahedral(normal) * 511.0 + 512.5);
    return uvec2(receiver | (bits.x << 20) | (bits.y << 30), packed_albedo | ((bits.y >> 2) << 24));
}

uint pack_facet(vec3 normal) {
    return packSnorm2x16(octahedral(normal));
}

// The normal, not normalised.
vec3 facet_direction(uint facet) {
    return from_octahedral(unpackSnorm2x16(facet), 1.0);
}

uint surface_receiver(uvec2 surface) {
    return surface.x & RECEIVER_MASK;
}

// The normal, not normalised.
vec3 surface_direction(uvec2 surface) {
    uvec2 bits = uvec2((surface.x >> 20) & 0x3FFu, (surface.x >> 30) | ((surface.y >> 24) << 2));
    return from_octahedral(vec2(bits) - 512.0, 511.0);
}
