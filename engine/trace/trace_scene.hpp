// Ray queries over a world: which surface a ray meets first, and whether anything stands in its
// way.
//
// Embree's tree proposes triangles from bounds that are padded against float rounding; each
// proposal is decided in double precision against the exact triangle (exact_geometry.hpp). So
// answers depend neither on the tree nor on how far from the origin the level lies. A scene that is
// never updated builds nothing.

#pragma once

#include "ecs/entity.hpp"
#include "engine/core/geometry.hpp"
#include "engine/scene/world.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace trace {

inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point that shadow rays start from.
struct Surface {
    glm::dvec3 position = {};
    glm::dvec3 normal = {}; ///< unit, geometric, on the side that is looked at; zero: no surface, a
                            ///< point in the air
    ecs::Entity entity;     ///< with `triangle`: what never shadows this point; kNoEntity: nothing
    std::uint32_t triangle = kNoTriangle; ///< first of its three indices in Mesh::indices
};

struct Hit : Surface {
    std::uint8_t patch_id = 0;    ///< as in Mesh::patch_ids
    bool receives = true;         ///< ShadowRole::receives of the entity
    double t = 0.0;               ///< in lengths of the ray's direction
    glm::dvec3 barycentrics = {}; ///< weights of the triangle's corners, add up to 1
};

class TraceScene {
public:
    TraceScene();
    explicit TraceScene(const scene::World& world) : TraceScene() { update(world); }
    ~TraceScene();
    TraceScene(TraceScene&&) noexcept;
    TraceScene& operator=(TraceScene&&) noexcept;

    /// Follows the world: rebuilds the geometry of entities whose mesh, pose or world transform
    /// changed, came or went. It remembers versions, so it must always be given the same world.
    /// Cost: nothing when no version changed; else one look-up per mesh instance, and a build of
    /// what changed.
    void update(const scene::World& world);

    /// The nearest surface along a ray, as a camera sees it: holes of alpha masks are open, and
    /// back faces of single-sided materials are not there.
    /// @param direction any length above zero; t counts in it
    [[nodiscard]] std::optional<Hit> intersect(
        const glm::dvec3& origin, const glm::dvec3& direction, double t_max = kInfinity) const;

    /// Whether a shadow caster stands between a surface and a light. Casters block from both sides;
    /// the surface's own triangle never does.
    /// @param to_light any length above zero
    /// @param t_max where the light is, in lengths of to_light; infinite for directional lights
    /// @param offset the ray starts this far above the surface, metres
    [[nodiscard]] bool
    occluded(const Surface& from, const glm::dvec3& to_light, double t_max, double offset) const;
    [[nodiscard]] bool
    occluded(const Surface& from, const glm::dvec3& to_light, double t_max = kInfinity) const {
        return occluded(from, to_light, t_max, default_offset());
    }

    /// Whether anything at all, caster or not, lies within `distance` metres along a ray: lines of
    /// sight.
    [[nodiscard]] bool
    occluded(const glm::dvec3& origin, const glm::dvec3& direction, double distance) const;

    /// 1e-6 of the diagonal of the scene's bounds, metres.
    [[nodiscard]] double default_offset() const;
    /// Of all triangles.
    [[nodiscard]] engine::WorldAabb bounds() const;
    [[nodiscard]] std::size_t triangle_count() const;
    /// Geometries built since the scene was made.
    [[nodiscard]] std::uint64_t build_count() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trace
