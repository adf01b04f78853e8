// Visibility of one light, exactly: at a point, and for every pixel of a camera. 1 is lit, 0 is
// dark.
//
// For a light with a size it is the part of its light that arrives, sum V_i (N.L_i)+ / sum (N.L_i)+
// over directions L_i to it; parts of the light below the receiver's horizon drop out. Range and
// cone play no role: lighting makes those pixels dark.

#pragma once

#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"
#include "engine/trace/trace_scene.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace trace {

/// How visibility is sampled.
struct VisibilityOptions {
    int samples = 64;             ///< directions to a light that has a size
    std::uint64_t seed = 1;       ///< the same seed gives the same numbers, whatever the threads
    std::optional<double> offset; ///< metres above the surface; none: the scene's default
    int threads = 0;              ///< 0: as many as the machine has
    std::function<void(double)>
        progress; ///< called on the calling thread with the part done, 0 to 1
};

/// The visibility of a light at a surface; 0 where it faces away. Lights that cast no shadow
/// give 1.
/// @param stream picks one of many independent sets of samples
double visibility(
    const TraceScene& scene,
    const scene::PlacedLight& light,
    const Surface& surface,
    const VisibilityOptions& options,
    std::uint64_t stream = 0);

/// The same for games: at any point.
/// @param normal unit; or zero for a point in the air, where every direction counts the same
float visibility(
    const TraceScene& scene,
    const scene::PlacedLight& light,
    const glm::dvec3& point,
    const glm::vec3& normal,
    int samples = 16,
    std::uint64_t seed = 1);

/// What a camera sees at one place of its picture.
struct TracedPixel {
    std::optional<Hit> hit;  ///< t is the view depth
    double visibility = 1.0; ///< 1 where nothing is hit or the entity does not receive shadows
    double n_dot_l = 0.0; ///< geometric normal towards the viewer, direction to the light's centre
};

/// @param place picture coordinates: (0.5, 0.5) is the centre of the first pixel, top left
TracedPixel trace_pixel(
    const TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const glm::dvec2& place,
    const VisibilityOptions& options,
    std::uint64_t stream = 0);

/// One value per pixel in each array, top row first.
struct VisibilityImage {
    int width = 0;
    int height = 0;
    std::vector<float> visibility;
    std::vector<std::uint32_t> entity;  ///< Entity::value; that of kNoEntity where nothing is hit
    std::vector<std::uint8_t> patch_id; ///< as in Mesh::patch_ids
    std::vector<float> depth;           ///< view depth, metres; infinite where nothing is hit
    std::vector<glm::vec3>
        normal;                 ///< unit, geometric, towards the viewer; zero where nothing is hit
    std::vector<float> n_dot_l; ///< 0 where nothing is hit

    VisibilityImage() = default;
    VisibilityImage(int width_px, int height_px);

    [[nodiscard]] std::size_t pixel_count() const { return visibility.size(); }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
               + static_cast<std::size_t>(x);
    }
    void set(std::size_t pixel, const TracedPixel& traced);
};

/// Traces every pixel centre of a camera.
VisibilityImage trace_visibility(
    const TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const VisibilityOptions& options = {});

/// Calls row(y) once for every y in [0, height), on several threads.
/// @param threads 0: as many as the machine has
/// @param progress may be empty; called on the calling thread
void for_each_row(
    int height,
    int threads,
    const std::function<void(double)>& progress,
    const std::function<void(int)>& row);

} // namespace trace
