#include "systems/shadows/volumes/volume_casters.hpp"

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// Mesh space. @pre the matrix can be inverted
glm::dvec4 light_in(const LightView& light, const glm::dmat4& world_from_mesh) {
    const glm::dmat4 mesh_from_world = glm::inverse(world_from_mesh);
    if (light.light.kind == scene::LightKind::directional)
        return mesh_from_world * glm::dvec4(-glm::dvec3(light.direction), 0.0);
    return {glm::dvec3(mesh_from_world * glm::dvec4(light.position, 1.0)), 1.0};
}

} // namespace

const std::vector<LayeredSurface>&
VolumeCasters::surfaces_of(const ShadowRequest& request, std::uint32_t mesh, int level) {
    const auto found = surfaces_.find({mesh, level});
    if (found != surfaces_.end()) return found->second;
    const scene::Mesh& source = request.world.assets.meshes[mesh];
    auto made = level == 0
                    ? make_layered_surfaces(source, request.remedies)
                    : make_layered_surfaces(
                        scene::as_mesh(source, source.proxies[static_cast<std::size_t>(level - 1)]),
                        request.remedies);
    return surfaces_.emplace(LevelKey{mesh, level}, std::move(made)).first->second;
}

const VolumeCasters::Kept& VolumeCasters::kept_of(
    const ShadowRequest& request,
    const CasterView& view,
    const VolumeKey& key,
    const CasterSurface& surface,
    const BuiltFrom& from) {
    Kept& kept = kept_[key];
    if (!kept.volume.indices.empty() && kept.from == from) return kept;
    const auto* posed = request.world.registry.try_get<scene::PosedMesh>(ecs::Entity{view.id});
    kept.positions =
        posed != nullptr ? posed->positions : request.world.assets.meshes[view.mesh].positions;
    builder_.build(surface, kept.positions, from.light_mesh, from.surrounded, kept.volume);
    kept.from = from;
    changed_ = true;
    ++built_count_;
    return kept;
}

void VolumeCasters::add(const ShadowRequest& request, const VolumeTask& task, std::size_t pass) {
    const CasterView& view = request.scene.casters[task.caster];
    const double determinant = glm::determinant(glm::dmat3(view.world_from_mesh));
    if (!std::isnormal(determinant)) return; // flat: it has no inside and shows nothing
    const LightView& light = request.scene.lights[request.light];
    const auto& registry = request.world.registry;
    const ecs::Entity entity{view.id};
    const bool lamp = light.light.kind != scene::LightKind::directional;
    const BuiltFrom from{
        view.mesh,
        registry.has<scene::PosedMesh>(entity) ? registry.version<scene::PosedMesh>(entity) : 0,
        light_in(light, view.world_from_mesh),
        lamp && view.bounds.contains(light.position)};
    VolumeCaster caster;
    caster.entity = view.id;
    caster.level = task.level;
    caster.pass = pass;
    caster.world_from_mesh = view.world_from_mesh;
    caster.light_mesh = from.light_mesh;
    caster.bounds = view.bounds;
    caster.mirrored = determinant < 0.0;
    caster.reaches = task.reaches;
    for (const LayeredSurface& piece : surfaces_of(request, view.mesh, task.level)) {
        const Kept& kept =
            kept_of(request, view, {view.id, task.level, caster.piece}, piece.surface, from);
        caster.volume = &kept.volume;
        caster.positions = &kept.positions;
        // What is seen is the caster, not its proxy.
        caster.shows_through = piece.open || from.surrounded || task.level > 0;
        caster.layers = view.convex && !from.surrounded && task.level == 0 ? 1 : piece.layers;
        casters_.push_back(caster);
        ++caster.piece;
    }
}

void VolumeCasters::gather_indices() {
    indices_.clear();
    for (VolumeCaster& caster : casters_) {
        caster.first_index = static_cast<std::uint32_t>(indices_.size());
        indices_.insert(
            indices_.end(), caster.volume->indices.begin(), caster.volume->indices.end());
    }
}

void VolumeCasters::update(const ShadowRequest& request) {
    if (!(remedies_ == request.remedies)) {
        surfaces_.clear();
        kept_.clear();
        remedies_ = request.remedies;
    }
    std::vector<VolumeKey> before;
    for (const VolumeCaster& caster : casters_)
        before.emplace_back(caster.entity, caster.level, caster.piece);
    casters_.clear();
    passes_.clear();
    built_count_ = 0;
    for (const VolumePass& pass : volume_passes(request)) {
        for (const VolumeTask& task : pass.tasks)
            add(request, task, passes_.size());
        passes_.push_back(pass.receivers);
    }
    std::vector<VolumeKey> now;
    for (const VolumeCaster& caster : casters_)
        now.emplace_back(caster.entity, caster.level, caster.piece);
    std::erase_if(kept_, [&](const auto& kept) {
        return std::find(now.begin(), now.end(), kept.first) == now.end();
    });
    changed_ = changed_ || now != before;
    if (changed_) {
        gather_indices();
        return;
    }
    std::uint32_t first = 0;
    for (VolumeCaster& caster : casters_) {
        caster.first_index = first;
        first += static_cast<std::uint32_t>(caster.volume->indices.size());
    }
}

} // namespace shadows
