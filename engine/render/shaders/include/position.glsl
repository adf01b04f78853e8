// From a depth back to where it was seen.

#include "render/shared/frame.h"

// Direction through the middle of this fragment's pixel, of length 1 along the view axis, relative space.
vec3 view_ray() {
    return ray_corner.xyz + gl_FragCoord.x * ray_per_x.xyz + gl_FragCoord.y * ray_per_y.xyz;
}

// @param depth as stored: near / view depth; must be > 0
vec3 position_from_depth(float depth) {
    return view_ray() * (size_near.z / depth);
}
