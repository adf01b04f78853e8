// Penumbrae from one map: how much of a light of a size passes at a place.
//
// A point of the light, given on its unit disc, is seen from the receiver through the texel at disc x height x
// MapPlace's `light`, where height is the depth that a blocker lies above the receiver: for parallel and perspective
// rays alike, as a pyramid's depth is one over distance. So a blocker takes light away just where it lies inside the
// cone between the receiver and the light, and each blocker that is found says how wide its penumbra is.
//
// Two blockers at different heights have a wide penumbra and a narrow one. Their mean would be too sharp for the one
// and too soft for the other, so they are told apart by height, filtered on their own and multiplied; the lower one is
// filtered where the higher one does not hide it.
//
// Source of the idea: R. Fernando, "Percentage-Closer Soft Shadows", SIGGRAPH 2005. Cone and clusters are ours.

const float GOLDEN_ANGLE = 2.39996323;
// Places lie on a spiral, the same for every pixel: noise would stay on the screen while the world moves.
const vec2 FIRST_TURN = vec2(1.0, 0.0);

// Heights whose ratio is larger than this are two clusters.
const float CLUSTER_RATIO = 2.0;
// What counts as inside the cone: this much of the height that is needed there.
const float NEEDED_HEIGHT = 0.5;

// Where a low blocker is seen beside a high one it is guessed to go on behind it. It may as well be a wall beside the
// receiver, that takes no light from it: this much of CREASE_TANGENT tells them apart.
const float GENTLE_CREASE = 0.25;

mat2 turn_by(float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return mat2(c, s, -s, c);
}

struct Blockers {
    float lowest; // heights
    float highest;
    float split; // between the clusters; 0 where there is one
    float low; // means of the clusters; of all where there is one
    float high;
};

// Looks for blockers inside the cone. Distances rise half evenly, half in geometric series from a texel on, because
// nothing is known of the heights yet. Each look takes the four texels that a filter of no width would, so what is seen
// here and what the filter finds agree for the smallest of lights.
Blockers find_blockers(MapPlace at, float per_map) {
    float texel_height = 1.0 / at.light[0][0];
    float reach = max(at.highest - at.depth, texel_height);
#ifdef SHORT_SEARCH
    reach = min(reach, 4.0 * texel_height);
#endif
    float octaves = log2(1.0 + reach / texel_height);
    const mat2 NEXT = turn_by(GOLDEN_ANGLE);
    vec2 turn = FIRST_TURN;
    vec4 found[SEARCH_TAPS];
    Blockers blockers = Blockers(1e30, 0.0, 0.0, 0.0, 0.0);
    float sum = 0.0;
    float count = 0.0;
    for (int i = 0; i < SEARCH_TAPS; ++i) {
        float share = float(i) / float(SEARCH_TAPS - 1);
        float height = 0.5 * (reach * share + (exp2(octaves * share) - 1.0) * texel_height);
        vec2 first = floor(at.texel + at.light * turn * height - 0.5) + 0.5;
        vec4 stored = textureGather(shadow_map, vec3((first + 0.5) * per_map, at.layer)).wzxy;
        // What is nearer to the light than was thought counts as if it were not: no filter leaves the map.
        vec4 above = min(stored - at.depth, vec4(reach)) * (1.0 - passes_at(at, first, stored));
        // Some outside the cone, too: a few looks may miss what is inside.
        found[i] = above * step(vec4(NEEDED_HEIGHT * height), above + texel_height);
        vec4 blocks = step(vec4(1e-12), found[i]);
        vec4 lowest = mix(vec4(1e30), found[i], blocks);
        blockers.lowest = min(blockers.lowest, min(min(lowest.x, lowest.y), min(lowest.z, lowest.w)));
        blockers.highest = max(blockers.highest, max(max(found[i].x, found[i].y), max(found[i].z, found[i].w)));
        sum += dot(found[i], vec4(1.0));
        count += dot(blocks, vec4(1.0));
        turn = NEXT * turn;
    }
    if (count == 0.0) return blockers;
    blockers.high = sum / count;
#ifndef ONE_CLUSTER
    if (blockers.highest <= blockers.lowest * CLUSTER_RATIO) return blockers;
    blockers.split = sqrt(blockers.lowest * blockers.highest);
    vec2 sums = vec2(0.0);
    vec2 counts = vec2(0.0);
    for (int i = 0; i < SEARCH_TAPS; ++i) {
        vec4 high = step(vec4(blockers.split), found[i]);
        vec4 low = step(vec4(1e-12), found[i]) * (1.0 - high);
        sums += vec2(dot(low, found[i]), dot(high, found[i]));
        counts += vec2(dot(low, vec4(1.0)), dot(high, vec4(1.0)));
    }
    blockers.low = sums.x / counts.x;
    blockers.high = sums.y / counts.y;
#endif
    return blockers;
}

// Texels: the least radius of a filter. Facets that graze the light shadow themselves in stripes a texel wide.
const float NARROWEST = 1.0;

// What a filter finds, as shares of the light.
struct Filtered {
    float closed; // by blockers between two heights
    float seen; // where nothing higher hides what lies between
    float low; // where lower blockers are seen, the nearest first
    float open; // where nothing is, the nearest first
};

// @param height of the blockers: sets the width
Filtered filter_between(MapPlace at, float per_map, float height, float above, float up_to) {
    const mat2 NEXT = turn_by(GOLDEN_ANGLE);
    vec2 turn = FIRST_TURN;
    MapPlace gentle = at;
    gentle.rise *= GENTLE_CREASE;
    float texel_height = 1.0 / at.light[0][0];
    Filtered sum = Filtered(0.0, 0.0, 0.0, 0.0);
    height = max(height, 1e-6 * texel_height);
    mat2 light = at.light * max(1.0, NARROWEST * texel_height / height);
    for (int i = 0; i < FILTER_TAPS; ++i) {
        float way = sqrt((float(i) + 0.5) / float(FILTER_TAPS)) * height;
        vec2 texel = at.texel + light * turn * way;
        vec2 first = floor(texel - 0.5) + 0.5;
        vec2 part = texel - first;
        vec4 stored = textureGather(shadow_map, vec3((first + 0.5) * per_map, at.layer)).wzxy;
        // Depth above the receiver; 0 where the light passes.
        vec4 found = (stored - at.depth) * (1.0 - passes_at(at, first, stored));
        vec2 row = vec2(1.0 - part.x, part.x);
        vec4 seen = vec4(row * (1.0 - part.y), row * part.y) * step(found, vec4(up_to));
        vec4 counts = 1.0 - step(found, vec4(max(above, NEEDED_HEIGHT * way)));
        sum.closed += dot(seen, counts);
        sum.seen += dot(seen, vec4(1.0));
        float near = texel_height * texel_height / (way * way + texel_height * texel_height);
        vec4 open = passes_at(gentle, first, stored);
        sum.low += near * dot(seen, (1.0 - open) * (1.0 - counts));
        sum.open += near * dot(seen, open);
        turn = NEXT * turn;
    }
    const float SHARE = 1.0 / float(FILTER_TAPS);
    return Filtered(sum.closed * SHARE, sum.seen * SHARE, sum.low, sum.open);
}

// @param per_map one over the texels per side
float light_through(MapPlace at, float per_map) {
    Blockers blockers = find_blockers(at, per_map);
    if (blockers.highest == 0.0) return 1.0;
    const float EVERYTHING = 1e30;
#ifdef ONE_WIDTH
    blockers.split = 0.0;
    blockers.high = 4.0 / at.light[0][0];
#endif
    Filtered high = filter_between(at, per_map, blockers.high, blockers.split, EVERYTHING);
    float lit = 1.0 - high.closed;
#ifndef ONE_CLUSTER
    bool wide = blockers.high * at.light[0][0] > 1.0; // more than a texel: else nothing low is hidden
    if (lit > 0.0 && (blockers.split > 0.0 || (wide && high.low > 0.0))) {
        float up_to = blockers.split > 0.0 ? blockers.split : blockers.lowest / CLUSTER_RATIO;
        Filtered low = filter_between(at, per_map, blockers.low, 0.0, up_to);
        // Where the low ones are hidden, they are as they are where the high ones end.
        float all = high.open + high.low;
        float hidden = all > 0.0 ? high.open / all : 1.0;
        float measured = low.seen > 0.0 ? 1.0 - low.closed / low.seen : hidden;
        lit *= mix(hidden, measured, low.seen);
    }
#endif
    return lit;
}
