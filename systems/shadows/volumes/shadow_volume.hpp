// The shadow volume of a caster as triangles over its own vertices: nothing is computed that is
// drawn, so that the lit cap meets the G-buffer bit for bit and sides meet caps without a gap. What
// is extruded goes to infinity (w = 0).
//
// Everything happens in mesh space, where the vertices are exact. One facing per triangle, computed
// once, decides about caps and sides alike.

#pragma once

#include "systems/shadows/volumes/caster_surface.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace shadows {

/// Indices of triangles, counter-clockwise outside. An index is 2 * vertex, and one more for the
/// vertex at infinity.
struct ShadowVolume {
    std::vector<std::uint32_t> indices;
    /// In this order: caps at infinity; sides; caps at the caster, as their triangles are wound;
    /// caps at the caster that face the light when wound the other way round, yet in the order of
    /// their triangles, because a rasteriser may round by the order of corners.
    std::uint32_t far_end = 0;
    std::uint32_t side_end = 0;
    std::uint32_t near_end = 0;
    std::uint32_t outline_edges = 0; ///< edges that sides were drawn from
};

/// Finds silhouettes again and again without asking for memory.
class VolumeBuilder {
public:
    /// @param positions   one per vertex of the mesh, as drawn
    /// @param light_mesh  where light comes from, mesh space: a place and 1, or the way to the
    /// light
    ///                    and 0
    /// @param surrounded  the light may be inside the caster: every triangle blocks by itself
    /// Cost: about 15 ns per triangle.
    void build(
        const CasterSurface& surface,
        std::span<const glm::vec3> positions,
        const glm::dvec4& light_mesh,
        bool surrounded,
        ShadowVolume& volume);

private:
    void weigh(
        const CasterSurface& surface,
        std::span<const glm::vec3> positions,
        const glm::dvec4& light_mesh,
        bool surrounded);
    void add_far_caps(const CasterSurface& surface, ShadowVolume& volume) const;
    void add_sides(const CasterSurface& surface, bool lamp, ShadowVolume& volume) const;
    void add_near_caps(const CasterSurface& surface, ShadowVolume& volume) const;

    std::vector<std::uint8_t> facing_; ///< as the triangle is wound
    std::vector<std::int8_t> weights_; ///< of each triangle, and 0 for none
    std::size_t cap_count_ = 0;        ///< triangles with a weight
    std::size_t facing_cap_count_ = 0;
};

} // namespace shadows
