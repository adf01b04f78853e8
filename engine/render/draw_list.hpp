// What a view draws: everything inside its frustum, gathered into instanced draws and these into
// buckets that share all state. Pure CPU; ten thousand objects become a handful of multi-draws.

#pragma once

#include "engine/core/geometry.hpp"
#include "engine/render/geometry_pool.hpp"
#include "engine/scene/receivers.hpp"

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace render {

/// One mesh of the world, ready to be drawn by any view.
struct DrawItem {
    ecs::Entity entity;
    std::uint32_t mesh = 0;
    std::int32_t base_vertex = 0;
    std::uint32_t first_receiver = 0;
    bool has_patches = true; ///< false: ids ran short, every pixel gets first_receiver
    bool mirrored = false;
    bool casts = true;
    glm::dmat4 world_from_mesh = glm::dmat4(1.0);
    engine::WorldAabb bounds;
};

/// Everything that may be drawn, kept in step with the world by versions.
class DrawItems {
public:
    void sync(
        const scene::World& world, const scene::ReceiverTable& receivers, const GeometryPool& pool);

    /// Sorted by mesh, mirrored ones last, then by entity: equal neighbours become one instanced
    /// draw.
    [[nodiscard]] const std::vector<DrawItem>& all() const { return items_; }

private:
    std::vector<DrawItem> items_;
    std::uint64_t versions_ = 0; ///< of the components that items come from
};

/// State that a draw needs.
struct DrawBucket {
    scene::Topology topology = scene::Topology::triangles;
    bool double_sided = false;
    bool mirrored = false;
    bool alpha_masked = false;
    std::uint32_t texture = scene::kNoTexture; ///< index into Assets::textures

    auto operator<=>(const DrawBucket&) const = default;
};

/// As glMultiDrawElementsIndirect reads it.
struct DrawCommand {
    std::uint32_t index_count = 0;
    std::uint32_t instance_count = 0;
    std::uint32_t first_index = 0;
    std::int32_t base_vertex = 0;
    std::uint32_t first_instance = 0;
};

/// Per-instance attributes of shared/bindings.h.
struct InstanceData {
    glm::vec4 row_0; ///< rows of relative_from_mesh
    glm::vec4 row_1;
    glm::vec4 row_2;
    glm::uvec4 surface; ///< receiver id of patch 0 (and SURFACE_WITHOUT_PATCHES), packed base
                        ///< color, bits of alpha, of the cutoff
};

/// The rows of a mesh that is placed relative to `origin`, without a surface: the same bits as in
/// every draw list with that origin.
InstanceData placed_instance(const glm::dmat4& world_from_mesh, const glm::dvec3& origin);

struct DrawList {
    struct Run {
        DrawBucket bucket;
        std::uint32_t first_command = 0;
        std::uint32_t command_count = 0;
        std::uint64_t triangles = 0;
    };
    std::vector<Run> runs;
    std::vector<DrawCommand> commands;
    std::vector<InstanceData> instances;
};

/// Items whose bounds meet the frustum of a projection, in their order.
/// @param origin what clip_from_relative is relative to, world space
std::vector<const DrawItem*> visible_items(
    std::span<const DrawItem> items, const glm::dvec3& origin, const glm::mat4& clip_from_relative);

/// The draws of some items, with everything that they show.
/// @param items in the order of DrawItems::all
/// @param origin what instances are placed relative to, world space
DrawList build_draw_list(
    std::span<const DrawItem* const> items,
    const scene::Assets& assets,
    const GeometryPool& pool,
    const glm::dvec3& origin);

/// The draws of casters as a light sees them: triangles only, textures only where they have holes,
/// and of closed meshes the side that faces the light alone.
/// @param eye where the light is: a mesh round it shows its inside; none for a directional light
DrawList build_caster_list(
    std::span<const DrawItem* const> items,
    const scene::Assets& assets,
    const GeometryPool& pool,
    const glm::dvec3& origin,
    const std::optional<glm::dvec3>& eye);

} // namespace render
