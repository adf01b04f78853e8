// What shadow decisions see of a frame: flat copies taken from the world once per frame. Techniques
// and the picker read these and nothing else: no registry, no Lua, no clock, no OpenGL.

#pragma once

#include "engine/core/geometry.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/description.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/proxy.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace shadows {

using LightView = scene::PlacedLight;

/// A simplified caster; see scene::Proxy.
struct ProxyView {
    std::uint32_t triangles = 0; ///< 0: there is none
    double deviation = 0.0;      ///< metres
};

/// A mesh that blocks light.
struct CasterView {
    std::uint32_t id = 0; ///< entity value
    std::string name;
    std::uint32_t mesh = 0; ///< index into the world's meshes
    glm::dmat4 world_from_mesh = glm::dmat4(1.0);
    engine::Aabb bounds_mesh; ///< of its vertices as posed, mesh space
    engine::WorldAabb bounds;
    bool hero = false;
    bool closed = false; ///< safe for a stencil volume, by the mesh's health
    bool convex = false; ///< it never darkens itself
    bool deforms = false;
    bool alpha_masked = false;
    std::uint32_t triangles = 0;
    double outline_edges = 6.0; ///< of its silhouette, on average; 6 are those of a box
    double outline_share = 1.0; ///< length of its silhouette in those of its box
    std::array<ProxyView, scene::kProxyLevels> proxies; ///< coarser and coarser

    [[nodiscard]] int proxy_count() const {
        return static_cast<int>(std::count_if(
            proxies.begin(), proxies.end(), [](const auto& proxy) { return proxy.triangles > 0; }));
    }
    /// What one box and several in its place are wrong by, per length of outline, metres (as
    /// scene::BoxSet has it); infinite where there are none.
    std::array<double, 2> box_deviation = {
        std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// A flat patch of a mesh, or the rest of it, that shows shadows.
struct ReceiverView {
    std::uint32_t id = 0;     ///< as the G-buffer has it
    std::uint32_t entity = 0; ///< entity value
    std::string name;         ///< "floor", or "floor#2" for its second patch
    engine::WorldAabb bounds;
    bool flat = false;
    glm::dvec3 normal = {}; ///< of a flat receiver: unit, outward
    double offset = 0.0;    ///< of a flat receiver: dot(normal, p) for its points
    double residual = 0.0;  ///< of a flat receiver: how far it leaves its plane, metres
    bool two_sided = false; ///< some of its mesh can be seen from behind
    bool casts = true;      ///< its mesh blocks light, too
};

/// One frame as shadows see it. Vectors are in the order of their meshes' names (then of
/// ids), so that no decision depends on the order in which entities were made.
struct ShadowScene {
    scene::CameraView camera;
    std::vector<LightView> lights; ///< those that are on
    std::vector<CasterView> casters;
    std::vector<ReceiverView> receivers;
    bool wraps_stencil = true;         ///< the driver counts as stencil volumes need it
    bool everything_receives = true;   ///< no mesh was told not to
    bool everything_casts = true;      ///< no receiver was told not to
    engine::WorldAabb receiver_bounds; ///< round all receivers
    double nearest_m = 0.0;            ///< from the camera to the nearest receiver's bounds
    double farthest_m = 0.0;           ///< from the camera to the farthest corner of any
    std::vector<std::uint32_t> place_of_receiver; ///< by id: an index into receivers

    /// @pre `id` is that of one of the lights
    [[nodiscard]] std::uint32_t index_of_light(std::uint32_t id) const {
        const auto found = std::find_if(
            lights.begin(), lights.end(), [&](const LightView& view) { return view.id == id; });
        return static_cast<std::uint32_t>(found - lights.begin());
    }
    [[nodiscard]] const LightView& light(std::uint32_t id) const {
        return lights[index_of_light(id)];
    }
    /// @pre measure_receivers() was called and `id` is a receiver's
    [[nodiscard]] const ReceiverView& receiver(std::uint32_t id) const {
        return receivers[place_of_receiver[id]];
    }
};

/// Fills what sums up and finds the receivers, once they and the camera are there.
void measure_receivers(ShadowScene& scene);

} // namespace shadows
