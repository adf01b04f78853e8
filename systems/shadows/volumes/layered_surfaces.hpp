// A caster's surface in pieces that a stencil can count: it comes round to nothing after 255, and
// one mesh can be a stack of more sheets than that. Each piece throws a volume of its own.

#pragma once

#include "systems/shadows/volumes/caster_surface.hpp"

#include <vector>

namespace shadows {

/// A stencil of eight bits counts that far before it comes round to nothing.
inline constexpr int kMostLayers = 255;

/// A surface, and what counting it takes.
struct LayeredSurface {
    CasterSurface surface;
    bool open = false; ///< some of it, or some is wound the wrong way round
    int layers = 0;    ///< most volumes that one pixel may be in
};

/// The surface as one piece where it has few enough layers, else in as few as halving gives: closed
/// parts stay whole unless one alone has too many. Empty for a mesh without triangles.
/// Cost: that of make_caster_surface(), twice for each time that a mesh is halved.
std::vector<LayeredSurface>
make_layered_surfaces(const scene::Mesh& mesh, const Remedies& remedies = {});

} // namespace shadows
