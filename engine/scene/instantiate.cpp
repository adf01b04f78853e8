// From a model file to entities: what is shared goes to Assets once, what is placed becomes
// entities.

#include "engine/scene/world.hpp"

#include <iterator>

namespace scene {

namespace {

template <class T>
void move_append(std::vector<T>& to, std::vector<T>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    from.clear();
}

void add_mesh(World& world, const ModelAssets& model, const Node& node, ecs::Entity entity) {
    const std::uint32_t index = model.first_mesh + *node.mesh;
    const Mesh& mesh = world.assets.meshes[index];
    world.registry.add(entity, MeshInstance{index});
    world.registry.add(entity, ShadowRole{});
    if (!mesh.morph_targets.empty())
        world.registry.add(
            entity,
            MorphWeights{node.morph_weights.empty() ? mesh.morph_weights : node.morph_weights});
    if (mesh.deforms())
        world.registry.add(entity, PosedMesh{mesh.positions, mesh.normals, mesh.bounds});
}

void add_skin(
    World& world,
    const ModelAssets& model,
    const Node& node,
    const std::vector<ecs::Entity>& entities,
    ecs::Entity entity) {
    Skinned skinned{model.first_skin + *node.skin, {}};
    for (const std::uint32_t joint : world.assets.skins[skinned.skin].joints)
        skinned.joints.push_back(entities[joint]);
    world.registry.add(entity, std::move(skinned));
}

} // namespace

ModelAssets add_assets(Assets& assets, Model&& model) {
    ModelAssets added;
    added.first_mesh = static_cast<std::uint32_t>(assets.meshes.size());
    added.first_skin = static_cast<std::uint32_t>(assets.skins.size());
    added.first_clip = static_cast<std::uint32_t>(assets.clips.size());
    added.clip_count = static_cast<std::uint32_t>(model.clips.size());

    const auto first_material = static_cast<std::uint32_t>(assets.materials.size());
    const auto first_texture = static_cast<std::uint32_t>(assets.textures.size());
    for (Mesh& mesh : model.meshes)
        for (Submesh& submesh : mesh.submeshes)
            submesh.material += first_material;
    for (Material& material : model.materials)
        if (material.texture != kNoTexture) material.texture += first_texture;

    move_append(assets.meshes, model.meshes);
    move_append(assets.materials, model.materials);
    move_append(assets.textures, model.textures);
    move_append(assets.skins, model.skins);
    move_append(assets.clips, model.clips);
    added.model = std::move(model);
    return added;
}

ecs::Entity instantiate(World& world, const ModelAssets& model, const std::string& name) {
    const auto make = [&](const std::string& entity_name, const Transform& transform) {
        const ecs::Entity entity = world.registry.create();
        world.registry.add(entity, Name{entity_name});
        world.registry.add(entity, transform);
        world.registry.add(entity, WorldTransform{});
        return entity;
    };
    const ecs::Entity root = make(name.empty() ? model.model.file : name, {});

    std::vector<ecs::Entity> entities;
    entities.reserve(model.model.nodes.size());
    for (const Node& node : model.model.nodes) {
        entities.push_back(make(name.empty() ? node.name : name + "/" + node.name, node.local));
        world.registry.add(entities.back(), Parent{node.parent ? entities[*node.parent] : root});
    }
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const Node& node = model.model.nodes[i];
        if (node.mesh) add_mesh(world, model, node, entities[i]);
        if (node.mesh && node.skin) add_skin(world, model, node, entities, entities[i]);
        if (node.camera) world.registry.add(entities[i], model.model.cameras[*node.camera]);
        if (node.light) world.registry.add(entities[i], model.model.lights[*node.light]);
    }
    if (model.clip_count > 0) {
        AnimationPlayer player;
        player.first_clip = model.first_clip;
        player.clip_count = model.clip_count;
        player.nodes = std::move(entities);
        world.registry.add(root, std::move(player));
    }
    return root;
}

} // namespace scene
