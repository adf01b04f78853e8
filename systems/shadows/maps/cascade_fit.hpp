// Where the cascades of a directional light lie. Built for stillness: sizes depend on nothing that
// a walking or turning camera changes from frame to frame, and corners lie on whole texels, so that
// every texel covers the same piece of the world as before.
//
// Sources: M. Valient, "Stable Rendering of Cascaded Shadow Maps", ShaderX6 (bounding spheres,
// whole texels); F. Zhang et al., "Parallel-Split Shadow Maps", 2006 (splits in geometric series).

#pragma once

#include "systems/shadows/maps/map_view.hpp"
#include "systems/shadows/remedies.hpp"
#include "systems/shadows/shadow_scene.hpp"

#include <optional>
#include <span>
#include <vector>

namespace shadows {

inline constexpr int kMaxCascades = 4;

/// View depths between which texels are spent, metres.
struct DepthRange {
    double near = 0.1;
    double far = 100.0;

    bool operator==(const DepthRange&) const = default;
};

/// The range that a frame would like: from the nearest receiver to the farthest.
DepthRange wanted_range(const ShadowScene& scene);

/// Steps of the range: as long as the one before still fits it stays, so that cascades keep their
/// size while the camera walks.
DepthRange steady_range(const DepthRange& wanted, const std::optional<DepthRange>& before);

/// A range as a job keeps it from frame to frame.
struct HeldRange {
    DepthRange range;
    int frames_too_large = 0; ///< for which less would have done
};

/// Frames for which less must do before a range shrinks.
inline constexpr int kHeldFrames = 60;

/// The range of the next frame: it grows at once and shrinks when less has done for a while, so
/// that something far away that comes and goes does not resize cascades each time.
HeldRange held_range(
    const DepthRange& wanted, const std::optional<HeldRange>& before, const Remedies& remedies);

/// Cascades that cover a range at about the same texel size on screen: one for each factor of 2.7,
/// at most kMaxCascades.
int cascade_count(const DepthRange& range);

/// The far ends of `count` slices, in geometric series.
std::vector<double> split_depths(const DepthRange& range, int count);

/// The far end of the slice that holds a view depth; of the nearest or the farthest slice outside.
double slice_end(const DepthRange& range, int count, double depth);

/// The light's rows right, up, along. Right is nearly level, so that a low sun's texels shrink with
/// the ground; near the vertical, where level is undefined, the axes before are turned along. It
/// rises by one in four: were texels to lie in rows along walls and floors, whole edges of shadows
/// would be off by up to half a texel, and no filter could tell.
glm::dmat3 light_axes(
    const glm::dvec3& direction, const std::optional<glm::dmat3>& before, const Remedies& remedies);

/// What a fit needs.
struct CascadeRequest {
    const scene::CameraView& camera;
    glm::dmat3 light_from_world = glm::dmat3(1.0);
    engine::WorldAabb receivers;                     ///< of the whole scene; not empty
    std::span<const engine::WorldAabb> casters = {}; ///< bounds; where none is, no texel is needed
    DepthRange range;
    int count = 1;
    int size = 1024;   ///< texels per side
    double soft = 0.0; ///< tangent of the light's angular radius, where penumbrae are looked for
};

/// From the nearest cascade to the farthest. Where all that casts and receives takes less room than
/// a cascade would, the cascade holds it whole and does not depend on the camera.
std::vector<ParallelView> fit_cascades(const CascadeRequest& request, const Remedies& remedies);

/// Whether a caster can darken anything inside a layer: its bounds, swept along the light, meet it.
bool reaches(const ParallelView& view, const engine::WorldAabb& caster);

} // namespace shadows
