// Vertex attributes and texture units, the same everywhere. Read by GLSL and by C++.

#ifndef RENDER_SHARED_BINDINGS_H
#define RENDER_SHARED_BINDINGS_H

#define ATTRIBUTE_POSITION 0
#define ATTRIBUTE_NORMAL 1
#define ATTRIBUTE_UV 2
#define ATTRIBUTE_PATCH 3
#define ATTRIBUTE_ROW_0 4
#define ATTRIBUTE_ROW_1 5
#define ATTRIBUTE_ROW_2 6
#define ATTRIBUTE_SURFACE 7

// In ATTRIBUTE_SURFACE.x: patch ids do not count, every pixel has the same receiver.
#define SURFACE_WITHOUT_PATCHES 0x80000000u

#define UNIT_BASE_COLOR 0
#define UNIT_GBUFFER 1
#define UNIT_DEPTH 2
#define UNIT_MASKS 3
#define UNIT_LIGHT 4
#define UNIT_FACETS 6

#endif
