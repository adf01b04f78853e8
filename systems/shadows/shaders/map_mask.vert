#version 450 core
// One triangle over the viewport, with the way to what each pixel shows and where the map lies. The map's numbers come
// as flat outputs: rasterisers that run on a CPU fetch a uniform anew for every pixel.

#include "render/include/view_ray.glsl"
#include "shadows/include/map_inputs.glsl"

uniform mat3 light_from_world;
uniform vec4 map_depth; // parallel: depth per metre along the light, depth of the camera; pyramid: near distance
uniform vec3 light_position; // pyramid: relative to the camera
// Texels per metre along right and up, and the texel of the camera; of a pyramid: per right and up over forward, and the
// texel straight ahead.
uniform vec4 placement[MAP_LAYERS];
uniform vec4 map_size; // texels per side, one over that, parallel: metres of border, texels of border
uniform vec2 light_source; // radius of the light, in the unit of right and up, per depth; nearest depth of a caster

noperspective out vec3 ray; // divided by depth: the position, relative space
flat out MapInputs map;

void main() {
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2)); // in viewports
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
    ray = view_ray(corner * size_near.xy) * size_near.z;
    mat3 rows = transpose(light_from_world);
    map.right = rows[0];
    map.up = rows[1];
    map.along = rows[2];
    map.light = light_position;
    map.depth = map_depth;
    map.size = map_size;
    map.source = light_source;
    for (int i = 0; i < MAP_LAYERS; ++i)
        map.placement[i] = placement[i];
}
