#include "systems/shadows/volumes/volume_casters.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace shadows {

namespace {

/// Where the plans' casters throw shadows, by index into ShadowScene::casters.
std::map<std::uint32_t, std::vector<SweptReach>> reaches_of(const ShadowRequest& request) {
    std::unordered_map<std::uint32_t, const ReceiverView*> receivers;
    for (const ReceiverView& receiver : request.scene.receivers)
        receivers[receiver.id] = &receiver;
    const LightView& light = request.scene.lights[request.light];
    std::map<std::uint32_t, std::vector<SweptReach>> reaches;
    for (const Plan* plan : request.plans)
        for (const PlanEntry& entry : plan->entries) {
            if (entry.technique != "volume") continue;
            const ReceiverView& receiver = *receivers.at(plan->receiver);
            for (const std::uint32_t group : entry.caster_groups)
                for (const std::uint32_t caster : request.groups[group].casters)
                    if (auto reach = swept_reach(
                            light, request.scene.casters[caster].bounds, receiver.bounds))
                        reaches[caster].push_back(*reach);
        }
    return reaches;
}

/// Mesh space. @pre the matrix can be inverted
glm::dvec4 light_in(const LightView& light, const glm::dmat4& world_from_mesh) {
    const glm::dmat4 mesh_from_world = glm::inverse(world_from_mesh);
    if (light.light.kind == scene::LightKind::directional)
        return mesh_from_world * glm::dvec4(-glm::dvec3(light.direction), 0.0);
    return {glm::dvec3(mesh_from_world * glm::dvec4(light.position, 1.0)), 1.0};
}

bool is_open(const CasterSurface& surface) {
    return std::any_of(
               surface.turned.begin(),
               surface.turned.end(),
               [](auto turned) { return turned != 0; })
           || std::any_of(surface.dark_weight.begin(), surface.dark_weight.end(), [](auto weight) {
                  return weight != 0;
              });
}

} // namespace

const VolumeCasters::Surface&
VolumeCasters::surface_of(const ShadowRequest& request, std::uint32_t mesh) {
    const auto found = surfaces_.find(mesh);
    if (found != surfaces_.end()) return found->second;
    const scene::Mesh& source = request.world.assets.meshes[mesh];
    Surface made{make_caster_surface(source, request.remedies)};
    made.open = is_open(made.surface);
    made.layers = count_layers(made.surface, source.positions);
    return surfaces_.emplace(mesh, std::move(made)).first->second;
}

void VolumeCasters::add(
    const ShadowRequest& request, const CasterView& view, std::vector<SweptReach> reaches) {
    const double determinant = glm::determinant(glm::dmat3(view.world_from_mesh));
    if (!std::isnormal(determinant)) return; // flat: it has no inside and shows nothing
    const LightView& light = request.scene.lights[request.light];
    const Surface& surface = surface_of(request, view.mesh);
    if (surface.surface.corners.empty()) return;
    const auto& registry = request.world.registry;
    const ecs::Entity entity{view.id};
    const auto* posed = registry.try_get<scene::PosedMesh>(entity);
    const bool lamp = light.light.kind != scene::LightKind::directional;
    const BuiltFrom from{
        view.mesh,
        posed != nullptr ? registry.version<scene::PosedMesh>(entity) : 0,
        light_in(light, view.world_from_mesh),
        lamp && view.bounds.contains(light.position)};
    Kept& kept = kept_[view.id];
    if (kept.volume.indices.empty() || kept.from != from) {
        const auto& positions =
            posed != nullptr ? posed->positions : request.world.assets.meshes[view.mesh].positions;
        builder_.build(surface.surface, positions, from.light_mesh, from.surrounded, kept.volume);
        kept.from = from;
        changed_ = true;
        ++built_count_;
    }
    VolumeCaster caster;
    caster.entity = view.id;
    caster.volume = &kept.volume;
    caster.world_from_mesh = view.world_from_mesh;
    caster.light_mesh = from.light_mesh;
    caster.bounds = view.bounds;
    caster.mirrored = determinant < 0.0;
    caster.shows_through = surface.open || from.surrounded;
    caster.layers = view.convex && !from.surrounded ? 1 : surface.layers;
    caster.reaches = std::move(reaches);
    casters_.push_back(std::move(caster));
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
    std::vector<std::uint32_t> before;
    for (const VolumeCaster& caster : casters_)
        before.push_back(caster.entity);
    casters_.clear();
    built_count_ = 0;
    for (auto& [index, reaches] : reaches_of(request))
        add(request, request.scene.casters[index], std::move(reaches));
    std::vector<std::uint32_t> now;
    for (const VolumeCaster& caster : casters_)
        now.push_back(caster.entity);
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
