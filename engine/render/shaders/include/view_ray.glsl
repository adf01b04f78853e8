// From a depth back to where it was seen.

#include "render/shared/frame.h"

// Direction through a point of the window, of length 1 along the view axis, relative space.
// @param window in pixels, from the lower left
vec3 view_ray(vec2 window) {
    return ray_corner.xyz + window.x * ray_per_x.xyz + window.y * ray_per_y.xyz;
}
