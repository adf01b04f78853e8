#include "engine/render/draw_list.hpp"

#include <glm/gtc/packing.hpp>
#include <render/shared/bindings.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <tuple>

namespace render {

namespace {

/// Changes whenever any component that a DrawItem copies changes.
std::uint64_t versions_of(const scene::World& world) {
    const auto& registry = world.registry;
    return registry.version<scene::MeshInstance>() + registry.version<scene::WorldTransform>()
           + registry.version<scene::ShadowRole>() + registry.version<scene::PosedMesh>();
}

DrawItem
make_item(const scene::World& world, const scene::ReceiverRange& range, const GeometryPool& pool) {
    const auto& registry = world.registry;
    const auto& placed = registry.get<scene::WorldTransform>(range.entity);
    DrawItem item;
    item.entity = range.entity;
    item.mesh = registry.get<scene::MeshInstance>(range.entity).mesh;
    item.base_vertex = registry.has<scene::PosedMesh>(range.entity)
                           ? pool.posed_base_vertex(range.entity)
                           : pool.slot(item.mesh).base_vertex;
    item.first_receiver = range.first;
    item.has_patches = range.count == 1 + world.assets.meshes[item.mesh].patches.size();
    item.mirrored = placed.mirrored();
    item.casts = registry.get<scene::ShadowRole>(range.entity).casts;
    item.world_from_mesh = placed.world_from_local;
    item.bounds = scene::world_bounds(world, range.entity);
    return item;
}

bool same_draw(const DrawItem& a, const DrawItem& b) {
    return a.mesh == b.mesh && a.mirrored == b.mirrored && a.base_vertex == b.base_vertex;
}

std::uint32_t packed_square_root(const glm::vec4& color) {
    const glm::vec3 root = glm::sqrt(glm::clamp(glm::vec3(color), 0.0F, 1.0F));
    return glm::packUnorm4x8(glm::vec4(root, 0.0F));
}

InstanceData
instance_of(const DrawItem& item, const scene::Material& material, const glm::dvec3& origin) {
    InstanceData data = placed_instance(item.world_from_mesh, origin);
    data.surface = {
        item.first_receiver | (item.has_patches ? 0U : SURFACE_WITHOUT_PATCHES),
        packed_square_root(material.base_color),
        std::bit_cast<std::uint32_t>(material.base_color.a),
        std::bit_cast<std::uint32_t>(material.alpha_cutoff)};
    return data;
}

DrawBucket
bucket_of(const scene::Submesh& submesh, const scene::Material& material, bool mirrored) {
    DrawBucket bucket;
    bucket.topology = submesh.topology;
    bucket.double_sided = material.double_sided || submesh.topology != scene::Topology::triangles;
    bucket.mirrored = mirrored;
    bucket.texture = material.texture;
    bucket.alpha_masked = material.alpha_masked && material.texture != scene::kNoTexture;
    return bucket;
}

/// The state that a submesh of an item needs, or none when it is not drawn.
using BucketOf = std::function<std::optional<DrawBucket>(
    const DrawItem& item, const scene::Submesh& submesh, const scene::Material& material)>;

/// A list while it grows: equal neighbours become one instanced draw.
class ListBuilder {
public:
    ListBuilder(const scene::Assets& assets, const GeometryPool& pool, const glm::dvec3& origin)
        : assets_(assets),
          pool_(pool),
          origin_(origin) {}

    /// @param same items that share one draw
    void add(std::span<const DrawItem* const> same, const BucketOf& bucket_of_submesh) {
        const DrawItem& first = *same.front();
        for (const scene::Submesh& submesh : assets_.meshes[first.mesh].submeshes) {
            const scene::Material& material = assets_.materials[submesh.material];
            // A material that is a hole everywhere draws nothing.
            if (material.alpha_masked && material.base_color.a < material.alpha_cutoff) continue;
            const auto bucket = bucket_of_submesh(first, submesh, material);
            if (!bucket) continue;
            DrawCommand command;
            command.index_count = submesh.index_count;
            command.instance_count = static_cast<std::uint32_t>(same.size());
            command.first_index = pool_.slot(first.mesh).first_index + submesh.first_index;
            command.base_vertex = first.base_vertex;
            command.first_instance = static_cast<std::uint32_t>(list_.instances.size());
            for (const DrawItem* item : same)
                list_.instances.push_back(instance_of(*item, material, origin_));
            buckets_[*bucket].push_back(command);
        }
    }

    DrawList finish() {
        for (const auto& [bucket, commands] : buckets_) {
            DrawList::Run run{bucket, static_cast<std::uint32_t>(list_.commands.size()), 0, 0};
            run.command_count = static_cast<std::uint32_t>(commands.size());
            for (const DrawCommand& command : commands)
                if (bucket.topology == scene::Topology::triangles)
                    run.triangles +=
                        std::uint64_t{command.index_count} / 3 * command.instance_count;
            list_.commands.insert(list_.commands.end(), commands.begin(), commands.end());
            list_.runs.push_back(run);
        }
        return std::move(list_);
    }

private:
    const scene::Assets& assets_;
    const GeometryPool& pool_;
    glm::dvec3 origin_;
    std::map<DrawBucket, std::vector<DrawCommand>> buckets_;
    DrawList list_;
};

/// Adds runs of neighbours that `same` holds for.
template <class Same>
void add_all(
    ListBuilder& builder,
    std::span<const DrawItem* const> items,
    const BucketOf& bucket_of_submesh,
    Same same) {
    for (std::size_t first = 0; first < items.size();) {
        std::size_t end = first + 1;
        while (end < items.size() && same(*items[first], *items[end]))
            ++end;
        builder.add(items.subspan(first, end - first), bucket_of_submesh);
        first = end;
    }
}

} // namespace

InstanceData placed_instance(const glm::dmat4& world_from_mesh, const glm::dvec3& origin) {
    const glm::dmat4 rows = glm::transpose(world_from_mesh);
    InstanceData data;
    data.row_0 = glm::vec4(glm::dvec4(glm::dvec3(rows[0]), rows[0].w - origin.x));
    data.row_1 = glm::vec4(glm::dvec4(glm::dvec3(rows[1]), rows[1].w - origin.y));
    data.row_2 = glm::vec4(glm::dvec4(glm::dvec3(rows[2]), rows[2].w - origin.z));
    return data;
}

void DrawItems::sync(
    const scene::World& world, const scene::ReceiverTable& receivers, const GeometryPool& pool) {
    const std::uint64_t versions = versions_of(world);
    if (versions == versions_ && items_.size() == receivers.ranges().size()) return;
    versions_ = versions;
    items_.clear();
    for (const scene::ReceiverRange& range : receivers.ranges())
        items_.push_back(make_item(world, range, pool));
    std::sort(items_.begin(), items_.end(), [](const DrawItem& a, const DrawItem& b) {
        return std::tie(a.mesh, a.mirrored, a.entity) < std::tie(b.mesh, b.mirrored, b.entity);
    });
}

std::vector<const DrawItem*> visible_items(
    std::span<const DrawItem> items,
    const glm::dvec3& origin,
    const glm::mat4& clip_from_relative) {
    const engine::Frustum frustum = engine::frustum_from_clip(clip_from_relative);
    std::vector<const DrawItem*> visible;
    for (const DrawItem& item : items)
        if (frustum.intersects(engine::relative_to(item.bounds, origin))) visible.push_back(&item);
    return visible;
}

DrawList build_draw_list(
    std::span<const DrawItem* const> items,
    const scene::Assets& assets,
    const GeometryPool& pool,
    const glm::dvec3& origin) {
    ListBuilder builder(assets, pool, origin);
    const BucketOf surface =
        [](const DrawItem& item, const scene::Submesh& submesh, const scene::Material& material) {
            return std::optional(bucket_of(submesh, material, item.mirrored));
        };
    add_all(builder, items, surface, same_draw);
    return builder.finish();
}

DrawList build_caster_list(
    std::span<const DrawItem* const> items,
    const scene::Assets& assets,
    const GeometryPool& pool,
    const glm::dvec3& origin,
    const std::optional<glm::dvec3>& eye) {
    const auto one_sided = [&](const DrawItem& item) {
        return assets.meshes[item.mesh].health.closed() && !(eye && item.bounds.contains(*eye));
    };
    const BucketOf caster = [&](const DrawItem& item,
                                const scene::Submesh& submesh,
                                const scene::Material& material) -> std::optional<DrawBucket> {
        if (submesh.topology != scene::Topology::triangles) return std::nullopt;
        DrawBucket bucket = bucket_of(submesh, material, item.mirrored);
        if (!bucket.alpha_masked) bucket.texture = scene::kNoTexture;
        bucket.double_sided = bucket.alpha_masked || !one_sided(item);
        if (bucket.double_sided) bucket.mirrored = false;
        return bucket;
    };
    ListBuilder builder(assets, pool, origin);
    add_all(builder, items, caster, [&](const DrawItem& a, const DrawItem& b) {
        return same_draw(a, b) && one_sided(a) == one_sided(b);
    });
    return builder.finish();
}

} // namespace render
