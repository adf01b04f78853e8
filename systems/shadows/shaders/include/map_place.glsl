// Where a point of a plane lies in a map, for every kind of map.
//
// A receiver is a plane, and a plane stays one in map space, for parallel and for perspective rays alike: depth is an
// affine function of the texel. So the depth to compare with is known at the centre of every texel that a filter reads,
// and no bias is needed to keep a slanted receiver out of its own shadow.
// Source of the idea: H. Dou et al., "Adaptive Depth Bias for Shadow Maps", JCGT 2014.

// The receiver under a pixel: a plane, and how well its depth is known.
struct Receiver {
    vec3 point;
    vec3 normal; // any length
    float unknown_texels;
};

struct MapPlace {
    vec2 texel; // from the lower left corner of the map; centres lie at halves
    float layer;
    float depth;
    vec2 slope; // depth per texel along the receiver
    float slack; // depth that rounding may take away
    float rise; // depth that another lit surface, meeting this one in a crease, may rise per texel
    mat2 light; // texels from here to where the light's edge is seen through a blocker, per depth above the receiver
    float highest; // depth of what may lie nearest to the light
};

// Rounding of a plane's normal and position, and the bend from a triangle to the next: below what any filter shows.
const float ROUNDING_TEXELS = 0.25;
// Of a triangle that is turned away from a light which still reaches the smooth surface that it stands for.
const float TURNED_TEXELS = 2.0;

// Where a floor meets a wall a filter reads texels of the wall, which stands before the plane of the floor and yet takes
// no light from it. A texel blocks only when it is nearer than a wall could be that rises from the receiver by this
// tangent. What is lost: casters lower than two texels begin their shadows up to a texel late.
const float CREASE_TANGENT = 2.0;

// Shadows fall on triangles, light on the smooth surface that they stand for.
// @param facet, shaded normals of the two, any length
// @param to_light from the receiver, any length
Receiver receiver_at(vec3 point, vec3 facet, vec3 shaded, vec3 to_light) {
    bool faces = dot(facet, to_light) > 0.0;
    return Receiver(point, faces ? facet : shaded, faces ? ROUNDING_TEXELS : TURNED_TEXELS);
}

float slack_of(Receiver receiver, float depth_per_texel, vec2 slope) {
    return receiver.unknown_texels * (depth_per_texel + abs(slope.x) + abs(slope.y));
}

#ifdef PARALLEL
// A receiver as the light sees it, before a layer is chosen.
struct Across {
    vec2 metres; // along right and up, from the camera
    float depth;
    vec2 tilt; // metres along the light per metre across it
};

Across across_light(MapInputs map, Receiver receiver) {
    Across seen;
    vec3 point = receiver.point;
#ifdef NORMAL_OFFSET
    point += normalize(receiver.normal) * (NORMAL_OFFSET / map.placement[MAP_LAYERS - 1].x);
#endif
    seen.metres = vec2(dot(map.right, point), dot(map.up, point));
    seen.depth = dot(map.along, point) * map.depth.x + map.depth.y;
#ifdef CONSTANT_BIAS
    seen.depth -= CONSTANT_BIAS * map.depth.x;
#endif
    seen.tilt = vec2(dot(map.right, receiver.normal), dot(map.up, receiver.normal)) / -dot(map.along, receiver.normal);
    return seen;
}

vec2 texel_in(Across seen, vec4 placement) {
    return seen.metres * placement.xy + placement.zw;
}

MapPlace place_parallel(MapInputs map, Receiver receiver, Across seen, vec4 placement, float layer) {
    vec2 depth_per_texel = map.depth.x / placement.xy;
    MapPlace at;
    at.texel = texel_in(seen, placement);
    at.layer = layer;
    at.depth = seen.depth;
    at.slope = seen.tilt * depth_per_texel;
    float largest = max(-depth_per_texel.x, -depth_per_texel.y);
    at.slack = slack_of(receiver, largest, at.slope);
    at.rise = CREASE_TANGENT * largest;
    at.light = mat2(placement.x, 0.0, 0.0, placement.y) * map.source.x;
    at.highest = map.source.y;
    return at;
}
#else
// A receiver relative to the light, in the light's axes.
Receiver from_light(MapInputs map, Receiver receiver) {
    mat3 axes = transpose(mat3(map.right, map.up, map.along));
    return Receiver(
        axes * (receiver.point - map.light), axes * receiver.normal, receiver.unknown_texels);
}

// @param receiver in the axes of the view: right, up, forward
MapPlace place_pyramid(MapInputs map, Receiver receiver, float layer) {
    vec3 point = receiver.point;
    float near = map.depth.x;
    vec4 place = map.placement[0];
    vec2 per_texel = 1.0 / place.xy; // of right and up over forward
    vec2 over_forward = point.xy / point.z;
    MapPlace at;
    at.texel = over_forward * place.xy + place.zw;
    at.layer = layer;
    at.depth = near / point.z;
    at.slope = receiver.normal.xy * (near / dot(receiver.normal, point)) * per_texel;
    float largest = max(per_texel.x, per_texel.y) * at.depth;
    at.slack = slack_of(receiver, largest, at.slope);
    at.rise = CREASE_TANGENT * largest;
    // A sphere off the axis is seen as an ellipse: longer away from the axis.
    float away = dot(over_forward, over_forward);
    mat2 ellipse = mat2(1.0) + outerProduct(over_forward, over_forward) / (1.0 + sqrt(1.0 + away));
    at.light = mat2(place.x, 0.0, 0.0, place.y) * ellipse * map.source.x;
    at.highest = map.source.y;
    return at;
}
#endif
