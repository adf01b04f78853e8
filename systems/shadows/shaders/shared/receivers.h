// Binding points of the shadow system. Read by GLSL and by C++.

#ifndef SHADOWS_SHARED_RECEIVERS_H
#define SHADOWS_SHARED_RECEIVERS_H

#define RECEIVER_BITS_BINDING 0
#define VOLUME_POSITIONS_BINDING 2
#define UNIT_VISIBILITY 5

#endif
