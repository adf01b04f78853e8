// Failures of the literature that the design rules out: a line each, and no case that could only
// pretend.

#include "tests/atlas/cases.hpp"

namespace atlas {

std::vector<Impossible> impossible() {
    return {
        {"B4",
         "a blob under a roof darkens what the roof has darkened already",
         "masks take the minimum of what is drawn into them; nothing is darkened twice"},
        {"T6",
         "the side of a box that is turned away from the lamp is darkened twice",
         "a mask lowers the light's own share alone, and a side that is turned away has none"},
        {"M9",
         "what lies beyond the map's border or beyond its far plane is smeared or dark",
         "maps cover what casts and receives; a border is never looked up, and depth 0 lets all "
         "light pass"},
        {"M12",
         "a normal offset moves the look-up to another face",
         "nothing is offset: depth is known at every texel"},
        {"M17",
         "light bleeds through where maps keep mean and variance",
         "maps keep depths, and compare each"},
        {"V13",
         "caps at infinity are cut off by a last bit of their depth",
         "depth is reversed: what lies at infinity has a depth of exactly 0, and no limit is near"},
        {"V15",
         "the terminator of a coarse mesh has teeth",
         "the truth has the same teeth: they are the mesh's, and shading's to hide"},
    };
}

} // namespace atlas
