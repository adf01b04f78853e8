#include "engine/render/draw_list.hpp"

#include <glm/gtc/packing.hpp>
#include <render/shared/bindings.h>

#include <algorithm>
#include <bit>
#include <cmath>
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
    const glm::dmat4 rows = glm::transpose(item.world_from_mesh);
    InstanceData data;
    data.row_0 = glm::vec4(glm::dvec4(glm::dvec3(rows[0]), rows[0].w - origin.x));
    data.row_1 = glm::vec4(glm::dvec4(glm::dvec3(rows[1]), rows[1].w - origin.y));
    data.row_2 = glm::vec4(glm::dvec4(glm::dvec3(rows[2]), rows[2].w - origin.z));
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

/// Commands of each bucket while a list grows.
using Buckets = std::map<DrawBucket, std::vector<DrawCommand>>;

void add_draws(
    std::span<const DrawItem* const> visible,
    const scene::Assets& assets,
    const GeometryPool& pool,
    const glm::dvec3& origin,
    Buckets& buckets,
    DrawList& list) {
    const DrawItem& first = *visible.front();
    for (const scene::Submesh& submesh : assets.meshes[first.mesh].submeshes) {
        const scene::Material& material = assets.materials[submesh.material];
        // A material that is a hole everywhere draws nothing.
        if (material.alpha_masked && material.base_color.a < material.alpha_cutoff) continue;
        DrawCommand command;
        command.index_count = submesh.index_count;
        command.instance_count = static_cast<std::uint32_t>(visible.size());
        command.first_index = pool.slot(first.mesh).first_index + submesh.first_index;
        command.base_vertex = first.base_vertex;
        command.first_instance = static_cast<std::uint32_t>(list.instances.size());
        for (const DrawItem* item : visible)
            list.instances.push_back(instance_of(*item, material, origin));
        buckets[bucket_of(submesh, material, first.mirrored)].push_back(command);
    }
}

void close_runs(const Buckets& buckets, DrawList& list) {
    for (const auto& [bucket, commands] : buckets) {
        DrawList::Run run{bucket, static_cast<std::uint32_t>(list.commands.size()), 0, 0};
        run.command_count = static_cast<std::uint32_t>(commands.size());
        for (const DrawCommand& command : commands)
            if (bucket.topology == scene::Topology::triangles)
                run.triangles += std::uint64_t{command.index_count} / 3 * command.instance_count;
        list.commands.insert(list.commands.end(), commands.begin(), commands.end());
        list.runs.push_back(run);
    }
}

} // namespace

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

DrawList build_draw_list(
    const std::vector<DrawItem>& items,
    const scene::Assets& assets,
    const GeometryPool& pool,
    const glm::dvec3& origin,
    const glm::mat4& clip_from_relative) {
    const engine::Frustum frustum = engine::frustum_from_clip(clip_from_relative);
    DrawList list;
    Buckets buckets;
    std::vector<const DrawItem*> visible;
    const auto flush = [&] {
        if (!visible.empty()) add_draws(visible, assets, pool, origin, buckets, list);
        visible.clear();
    };
    for (const DrawItem& item : items) {
        if (!frustum.intersects(engine::relative_to(item.bounds, origin))) continue;
        if (!visible.empty() && !same_draw(*visible.front(), item)) flush();
        visible.push_back(&item);
    }
    flush();
    close_runs(buckets, list);
    return list;
}

} // namespace render
