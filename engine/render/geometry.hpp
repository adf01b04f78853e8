// The frame's meshes on the device, for whoever draws them again from elsewhere than the camera:
// shadow maps, planar shadows, volumes.

#pragma once

#include "engine/render/draw_list.hpp"
#include "engine/render/textures.hpp"

#include <span>

namespace render {

/// Valid while the frame is drawn.
struct Geometry {
    const scene::World& world;
    const GeometryPool& pool;
    const Textures& textures;
    std::span<const DrawItem> items; ///< every mesh of the world, in the order of DrawItems::all
};

} // namespace render
