// Posing meshes: morph targets first, then joints. A mesh is posed again only when something that
// moves it has a new version.
//
// Source: glTF 2.0 specification, 3.7.2.2 (morph targets) and 3.7.3 (skins).

#include "engine/scene/world.hpp"

#include <cmath>

namespace scene {

namespace {

/// Component: the versions of everything that the entity's PosedMesh was made from.
struct PosedFrom {
    std::vector<std::uint64_t> versions;
};

void collect_versions(
    const ecs::Registry& registry, ecs::Entity entity, std::vector<std::uint64_t>& versions) {
    versions.clear();
    versions.push_back(registry.version<MeshInstance>(entity));
    versions.push_back(registry.version<MorphWeights>(entity));
    const auto* skinned = registry.try_get<Skinned>(entity);
    if (!skinned) return;
    versions.push_back(registry.version<Skinned>(entity));
    versions.push_back(registry.version<WorldTransform>(entity));
    for (const ecs::Entity joint : skinned->joints)
        versions.push_back(registry.version<WorldTransform>(joint));
}

glm::dmat4 world_from_local(const ecs::Registry& registry, ecs::Entity entity) {
    const auto* placed = registry.try_get<WorldTransform>(entity);
    return placed ? placed->world_from_local : glm::dmat4(1.0);
}

/// What takes mesh space to the posed mesh's own space, one matrix per joint.
std::vector<glm::mat4>
posed_from_mesh(const World& world, ecs::Entity entity, const Skinned& skinned) {
    const glm::dmat4 placed = world_from_local(world.registry, entity);
    // A mesh that its node flattens shows nothing, whatever its pose.
    const bool flat = !std::isnormal(glm::determinant(placed));
    const glm::dmat4 local_from_world = flat ? glm::dmat4(1.0) : glm::inverse(placed);
    const Skin& skin = world.assets.skins[skinned.skin];
    std::vector<glm::mat4> matrices;
    matrices.reserve(skinned.joints.size());
    for (std::size_t i = 0; i < skinned.joints.size(); ++i)
        matrices.emplace_back(
            local_from_world * world_from_local(world.registry, skinned.joints[i])
            * glm::dmat4(skin.joint_from_mesh[i]));
    return matrices;
}

void morph(const Mesh& mesh, const std::vector<float>& weights, PosedMesh& posed) {
    for (std::size_t target = 0; target < mesh.morph_targets.size() && target < weights.size();
         ++target) {
        const float weight = weights[target];
        if (weight == 0.0F) continue;
        const MorphTarget& deltas = mesh.morph_targets[target];
        for (std::size_t i = 0; i < deltas.position_deltas.size(); ++i)
            posed.positions[i] += weight * deltas.position_deltas[i];
        for (std::size_t i = 0; i < deltas.normal_deltas.size(); ++i)
            posed.normals[i] += weight * deltas.normal_deltas[i];
    }
}

/// Takes normals along: the inverse transpose without the division, turned back where the matrix
/// mirrors.
glm::mat3 normal_matrix(const glm::mat3& matrix) {
    const glm::mat3 cofactors(
        glm::cross(matrix[1], matrix[2]),
        glm::cross(matrix[2], matrix[0]),
        glm::cross(matrix[0], matrix[1]));
    return glm::dot(matrix[0], cofactors[0]) < 0.0F ? -cofactors : cofactors;
}

void skin(const Mesh& mesh, const std::vector<glm::mat4>& matrices, PosedMesh& posed) {
    for (std::size_t i = 0; i < mesh.influences.size(); ++i) {
        const JointInfluence& influence = mesh.influences[i];
        glm::mat4 blended(0.0F);
        for (int k = 0; k < 4; ++k)
            if (influence.weights[k] != 0.0F)
                blended +=
                    influence.weights[k] * matrices[influence.joints[static_cast<std::size_t>(k)]];
        posed.positions[i] = glm::vec3(blended * glm::vec4(posed.positions[i], 1.0F));
        posed.normals[i] = normal_matrix(glm::mat3(blended)) * posed.normals[i];
    }
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Whatever the weights and matrices did, positions are numbers, normals have length 1 and bounds
/// fit.
void settle(const Mesh& mesh, PosedMesh& posed) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!finite(posed.positions[i])) posed.positions[i] = mesh.positions[i];
        const double length = glm::length(glm::dvec3(posed.normals[i]));
        posed.normals[i] = std::isnormal(length) ? glm::vec3(glm::dvec3(posed.normals[i]) / length)
                                                 : mesh.normals[i];
    }
    posed.bounds = {};
    for (const std::uint32_t index : mesh.indices)
        posed.bounds.grow(posed.positions[index]);
}

} // namespace

void pose_meshes(World& world) {
    ecs::Registry& registry = world.registry;
    std::vector<std::uint64_t> versions;
    for (const ecs::Entity entity : registry.view<MeshInstance, PosedMesh>()) {
        collect_versions(registry, entity, versions);
        if (!registry.has<PosedFrom>(entity)) registry.add<PosedFrom>(entity);
        if (registry.get<PosedFrom>(entity).versions == versions) continue;
        registry.patch<PosedFrom>(entity, [&](PosedFrom& from) { from.versions = versions; });

        const Mesh& mesh = world.assets.meshes[registry.get<MeshInstance>(entity).mesh];
        const auto* weights = registry.try_get<MorphWeights>(entity);
        const auto* skinned = registry.try_get<Skinned>(entity);
        registry.patch<PosedMesh>(entity, [&](PosedMesh& posed) {
            posed.positions = mesh.positions;
            posed.normals = mesh.normals;
            if (weights) morph(mesh, weights->weights, posed);
            if (skinned) skin(mesh, posed_from_mesh(world, entity, *skinned), posed);
            settle(mesh, posed);
        });
    }
}

} // namespace scene
