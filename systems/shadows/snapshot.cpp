#include "systems/shadows/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace shadows {

namespace {

std::string name_of(const scene::World& world, ecs::Entity entity) {
    const auto* name = world.registry.try_get<scene::Name>(entity);
    return name != nullptr ? name->text : fmt::format("entity {}", entity.index());
}

bool alpha_masked(const scene::Assets& assets, const scene::Mesh& mesh) {
    return std::any_of(
        mesh.submeshes.begin(), mesh.submeshes.end(), [&](const scene::Submesh& submesh) {
            return assets.materials[submesh.material].alpha_masked;
        });
}

bool two_sided(const scene::Assets& assets, const scene::Mesh& mesh) {
    return std::any_of(
        mesh.submeshes.begin(), mesh.submeshes.end(), [&](const scene::Submesh& submesh) {
            return assets.materials[submesh.material].double_sided;
        });
}

/// The most that a length of the mesh may grow. Source: the largest singular value; where axes stay
/// at right angles that of an axis, else at most the root of the sum of squares (Frobenius).
double largest_scale(const glm::dmat4& world_from_mesh) {
    const glm::dmat3 linear(world_from_mesh);
    const glm::dmat3 products = glm::transpose(linear) * linear;
    const double sum = products[0][0] + products[1][1] + products[2][2];
    const double skew =
        std::max({std::abs(products[0][1]), std::abs(products[0][2]), std::abs(products[1][2])});
    const double most = std::max({products[0][0], products[1][1], products[2][2]});
    return std::sqrt(skew <= 1e-6 * most ? most : sum);
}

CasterView
make_caster(const scene::World& world, ecs::Entity entity, const glm::dmat4& world_from_mesh) {
    const auto mesh_index = world.registry.get<scene::MeshInstance>(entity).mesh;
    const scene::Mesh& mesh = world.assets.meshes[mesh_index];
    CasterView caster;
    caster.id = entity.value;
    caster.name = name_of(world, entity);
    caster.mesh = mesh_index;
    caster.world_from_mesh = world_from_mesh;
    const auto* posed = world.registry.try_get<scene::PosedMesh>(entity);
    caster.bounds_mesh = posed != nullptr ? posed->bounds : mesh.bounds;
    caster.bounds = scene::world_bounds(world, entity);
    caster.hero = world.registry.get<scene::ShadowRole>(entity).hero;
    caster.closed = mesh.health.closed();
    caster.deforms = mesh.deforms();
    caster.convex = mesh.health.convex && !caster.deforms;
    caster.alpha_masked = alpha_masked(world.assets, mesh);
    caster.triangles = mesh.health.triangles;
    caster.outline_edges = mesh.health.outline_edges;
    const glm::vec3 sides = mesh.bounds.extent();
    const double of_box = static_cast<double>(sides.x + sides.y + sides.z) * std::numbers::pi / 2.0;
    caster.outline_share = of_box > 0.0 ? mesh.health.outline / of_box : 0.0;
    const double scale =
        mesh.proxies.empty() && mesh.box_sets.empty() ? 0.0 : largest_scale(world_from_mesh);
    for (std::size_t i = 0; i < mesh.proxies.size(); ++i)
        caster.proxies[i] = {
            mesh.proxies[i].triangle_count(),
            static_cast<double>(mesh.proxies[i].deviation) * scale};
    if (posed == nullptr && !caster.alpha_masked)
        for (std::size_t i = 0; i < std::min(mesh.box_sets.size(), caster.box_deviation.size());
             ++i)
            caster.box_deviation[i] = static_cast<double>(mesh.box_sets[i].deviation) * scale;
    return caster;
}

/// A patch's plane in the world. Source: normals transform by the inverse transpose.
void place_plane(
    ReceiverView& receiver, const scene::FlatPatch& patch, const glm::dmat4& world_from_mesh) {
    const glm::dmat3 linear(world_from_mesh);
    const glm::dvec3 turned = glm::transpose(glm::inverse(linear)) * glm::dvec3(patch.normal);
    const glm::dvec3 on_plane(glm::dvec3(patch.normal) * static_cast<double>(patch.offset));
    receiver.flat = true;
    receiver.normal = glm::normalize(turned);
    receiver.offset =
        glm::dot(receiver.normal, glm::dvec3(world_from_mesh * glm::dvec4(on_plane, 1.0)));
    receiver.residual = static_cast<double>(patch.residual) / glm::length(turned);
}

void add_receivers(
    ShadowScene& scene,
    const scene::World& world,
    const scene::ReceiverRange& range,
    const glm::dmat4& world_from_mesh) {
    const scene::Mesh& mesh =
        world.assets.meshes[world.registry.get<scene::MeshInstance>(range.entity).mesh];
    const std::string name = name_of(world, range.entity);
    const bool casts = world.registry.get<scene::ShadowRole>(range.entity).casts;
    const bool seen_from_behind = two_sided(world.assets, mesh);
    for (std::uint32_t part = 0; part < range.count; ++part) {
        if (part == 0 && range.count > 1 && !mesh.has_rest) continue;
        ReceiverView receiver;
        receiver.id = range.first + part;
        receiver.entity = range.entity.value;
        receiver.two_sided = seen_from_behind;
        receiver.casts = casts;
        receiver.name = part == 0 ? name : fmt::format("{}#{}", name, part);
        if (part == 0) {
            receiver.bounds = scene::world_bounds(world, range.entity);
        } else {
            const scene::FlatPatch& patch = mesh.patches[part - 1];
            receiver.bounds = engine::transformed(world_from_mesh, patch.bounds);
            if (glm::determinant(glm::dmat3(world_from_mesh)) != 0.0)
                place_plane(receiver, patch, world_from_mesh);
        }
        scene.receivers.push_back(std::move(receiver));
    }
}

/// Meshes by name, then in the order of the table.
std::vector<const scene::ReceiverRange*>
by_name(const scene::World& world, const scene::ReceiverTable& receivers) {
    std::vector<std::pair<std::string, const scene::ReceiverRange*>> named;
    named.reserve(receivers.ranges().size());
    for (const scene::ReceiverRange& range : receivers.ranges())
        named.emplace_back(name_of(world, range.entity), &range);
    std::sort(named.begin(), named.end(), [](const auto& a, const auto& b) {
        const int names = a.first.compare(b.first);
        return names != 0 ? names < 0 : a.second->first < b.second->first;
    });
    std::vector<const scene::ReceiverRange*> sorted;
    sorted.reserve(named.size());
    for (const auto& [name, range] : named)
        sorted.push_back(range);
    return sorted;
}

} // namespace

ShadowScene take_snapshot(
    const scene::World& world,
    const scene::ReceiverTable& receivers,
    const scene::CameraView& camera,
    std::span<const scene::PlacedLight> lights) {
    ShadowScene scene;
    scene.camera = camera;
    scene.lights.assign(lights.begin(), lights.end());
    for (const scene::ReceiverRange* range : by_name(world, receivers)) {
        const glm::dmat4& placed =
            world.registry.get<scene::WorldTransform>(range->entity).world_from_local;
        const auto& role = world.registry.get<scene::ShadowRole>(range->entity);
        if (role.casts) scene.casters.push_back(make_caster(world, range->entity, placed));
        if (role.receives) add_receivers(scene, world, *range, placed);
        scene.everything_receives = scene.everything_receives && role.receives;
        scene.everything_casts = scene.everything_casts && (role.casts || !role.receives);
    }
    measure_receivers(scene);
    return scene;
}

void measure_receivers(ShadowScene& scene) {
    const glm::dvec3& eye = scene.camera.position;
    scene.receiver_bounds = {};
    scene.nearest_m = scene.receivers.empty() ? 0.0 : std::numeric_limits<double>::infinity();
    scene.farthest_m = 0.0;
    scene.place_of_receiver.clear();
    for (std::uint32_t place = 0; place < scene.receivers.size(); ++place) {
        const ReceiverView& receiver = scene.receivers[place];
        if (receiver.id >= scene.place_of_receiver.size())
            scene.place_of_receiver.resize(receiver.id + 1);
        scene.place_of_receiver[receiver.id] = place;
        const engine::WorldAabb& bounds = receiver.bounds;
        scene.receiver_bounds.grow(bounds);
        const glm::dvec3 nearest = glm::clamp(eye, bounds.min, bounds.max);
        scene.nearest_m = std::min(scene.nearest_m, glm::length(nearest - eye));
        const glm::dvec3 farthest =
            glm::max(glm::abs(bounds.min - eye), glm::abs(bounds.max - eye));
        scene.farthest_m = std::max(scene.farthest_m, glm::length(farthest));
    }
}

} // namespace shadows
