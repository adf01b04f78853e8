// The true visibility of one light over a picture, and how sure of it we are.
//
// A pixel is undecided when its visibility depends on choices that are not the scene's: how far
// above the surface the shadow ray starts, or where in a hair's breadth round the centre the pixel
// was sampled. Two correct renderers may honestly differ there.

#pragma once

#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"
#include "engine/trace/trace_scene.hpp"
#include "engine/trace/visibility.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace truth {

struct TruthOptions {
    trace::VisibilityOptions visibility;
    /// Tests every pixel for being undecided, not only those near an edge of the shadow or of the
    /// geometry.
    bool all_pixels = false;
};

struct TruthImage {
    trace::VisibilityImage image;
    std::vector<std::uint8_t> undecided; ///< 1 where the truth is not sure, one per pixel
};

/// Parts of the pixels that show a surface, 0 to 1.
struct Shares {
    double surface = 0.0;     ///< of all pixels
    double shadow = 0.0;      ///< less than half lit, of those that face the light
    double facing_away = 0.0; ///< from the light
    double undecided = 0.0;
    double undecided_inside =
        0.0; ///< undecided with no edge of the shadow or of an entity in the 8 pixels around
};

TruthImage true_visibility(
    const trace::TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const TruthOptions& options = {});

/// The truth half a pixel right of and below the pixels' centres: a second picture that is as true
/// as the first.
trace::VisibilityImage second_grid(
    const trace::TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const trace::VisibilityOptions& options);

/// Whether the light reaches one place of a disc of the picture and not another: an edge that
/// pixels need not show. Places are those that are seen, and those of the plane that is seen in the
/// middle, also where something hides it or it ends: a shadow's edge beyond a ridge is as near as
/// one before it. Found when it is longer than a tenth of a pixel in the disc's middle, or of the
/// disc. Only seen surfaces that face the light by more than `least_n_dot_l` count.
/// @param lit what the middle is known to be
/// @param radius_px of the disc
bool edge_near(
    const trace::TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const glm::dvec2& middle,
    bool lit,
    double radius_px,
    double least_n_dot_l);

/// Where the surfaces of a picture are, world space, for choosing points to follow.
std::vector<glm::dvec3>
surface_points(const scene::CameraView& camera, const trace::VisibilityImage& image);

Shares shares(const TruthImage& truth);

/// 1 where a rasteriser shows the same surface as the truth: the same entity, and a view depth that
/// differs by less than a thousandth. Anything else is a silhouette of the geometry, where neither
/// is wrong.
/// @param entity_ids Entity::value per pixel, top row first; that of kNoEntity where nothing is
/// drawn
/// @param depth view depth per pixel, metres
/// @pre one value per pixel in both
std::vector<std::uint8_t> validity(
    const TruthImage& truth,
    std::span<const std::uint32_t> entity_ids,
    std::span<const float> depth);

} // namespace truth
