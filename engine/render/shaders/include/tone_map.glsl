// From light to what a display takes.

// Exposed linear light into encoded colour in [0, 1]: a film curve and the display's gamma in one fraction, without
// powers, which processors round differently. Source: J. Hejl and R. Burgess-Dawson, "Filmic Tonemapping for Real-time
// Rendering", SIGGRAPH 2010 course notes.
vec3 display_color(vec3 light) {
    // Brighter than this is white anyway; the product of the denominators stays finite.
    vec3 above_toe = min(max(light - 0.004, 0.0), 1e4);
    vec3 over = above_toe * (6.2 * above_toe + 0.5);
    vec3 under = above_toe * (6.2 * above_toe + 1.7) + 0.06;
    // Three fractions for the price of one division.
    vec3 others = under.gbr * under.brg;
    return over * others / (under.r * others.r);
}
