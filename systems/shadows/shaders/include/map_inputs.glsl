// What the mask of a shadow map knows of its map, from vertex shader to fragment shader.
//
// MAP_LAYERS: cascades of a parallel map; 1 for pyramids, whose faces lie alike.

struct MapInputs {
    vec3 right; // the light's axes, world space
    vec3 up;
    vec3 along;
    vec3 light; // pyramid: position of the light, relative space
    vec4 depth;
    vec4 size;
    vec2 source; // texels over placement of the light's edge, per depth; depth of what may lie nearest to the light
    vec4 placement[MAP_LAYERS];
};
