// From light to what a display takes.

// Exposed linear light into [0, 1]. Source: K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016.
vec3 tone_map(vec3 light) {
    return clamp(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0.0, 1.0);
}

// Within half a step of 8 bits of the sRGB curve, by square roots, which all processors round alike (powers are
// not). Source: I. Taylor ("Chilliant"), "sRGB Approximations for HLSL", 2012; linear part from IEC 61966-2-1.
vec3 encode_srgb(vec3 linear) {
    vec3 root_2 = sqrt(linear);
    vec3 root_4 = sqrt(root_2);
    vec3 root_8 = sqrt(root_4);
    vec3 curve = 0.662002687 * root_2 + 0.684122060 * root_4 - 0.323583601 * root_8 - 0.0225411470 * linear;
    return mix(linear * 12.92, curve, greaterThan(linear, vec3(0.0031308)));
}
