// One light of one frame, drawn and true, made ready for the figures.

#pragma once

#include <cstdint>
#include <vector>

#include "tools/gnomon/studio.hpp"
#include "tools/measure/mask.hpp"
#include "tools/truth/truth.hpp"

namespace gnomon {

/// What the rasteriser saw: one value per pixel, top row first.
struct DrawnSurfaces {
    std::vector<std::uint32_t> receiver; ///< its id; 0 where nothing is
    std::vector<std::uint32_t> entity;   ///< Entity::value; that of kNoEntity where nothing is
    std::vector<float> depth;            ///< view depth, metres
    std::vector<glm::vec3> normal;       ///< unit, as it is shaded
};

/// Of the studio's last frame.
DrawnSurfaces drawn_surfaces(Studio& studio, const scene::CameraView& camera);

/// A light whose edges have a width.
bool is_soft(const scene::Light& light);

/// Every pixel classified; where a light ends before the surface, by its range or its cone, it
/// counts as turned away: nothing there depends on its mask. Pictures are left empty.
measure::Comparison make_comparison(
    const engine::Image& mask,
    const truth::TruthImage& truth,
    const DrawnSurfaces& drawn,
    const scene::CameraView& camera,
    const scene::PlacedLight& light);

/// Marks edges that pixels do not show, where an error would count as a wrong shape: looks closer
/// there. Where there are very many, they are one, and nothing is marked.
/// @param tracer of the world that was drawn
/// @pre comparison.resolution_band_px is filled
void find_hidden_edges(
    const trace::TraceScene& tracer,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    measure::Comparison& comparison);

} // namespace gnomon
