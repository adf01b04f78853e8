// A world: the entities of a level and the assets they share. Systems over it are free functions.

#pragma once

#include "ecs/registry.hpp"
#include "engine/core/result.hpp"
#include "engine/scene/components.hpp"
#include "engine/scene/model.hpp"
#include "engine/scene/path.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace scene {

/// Everything that several entities may share. Only grows while a world lives; indices stay valid.
struct Assets {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Skin> skins;
    std::vector<AnimationClip> clips; ///< channel.node counts in the nodes of its own model
    std::vector<Path> paths;
};

/// What update_world_transforms remembers from call to call, so that a still world costs three
/// comparisons.
struct PlacementOrder {
    static constexpr std::uint32_t kNoParent = 0xFFFFFFFFU;
    struct Entry {
        ecs::Entity entity;
        std::uint32_t parent = kNoParent;    ///< index of an earlier entry
        std::uint64_t transform_version = 0; ///< of the Transform that WorldTransform was made from
    };
    std::vector<Entry> entries; ///< parents first
    std::uint64_t transforms_version = 0;
    std::uint64_t parents_version = 0;
    std::uint64_t world_transforms_version = 0;
};

/// Which world this is. No two worlds of a process share one, so that nothing made from a world is
/// ever taken for another's; it moves with its world, and a copy is another world.
class WorldIdentity {
public:
    WorldIdentity();
    WorldIdentity(const WorldIdentity& /*another*/) : WorldIdentity() {}
    WorldIdentity(WorldIdentity&&) noexcept = default;
    WorldIdentity& operator=(const WorldIdentity& /*another*/) { return *this = WorldIdentity(); }
    WorldIdentity& operator=(WorldIdentity&&) noexcept = default;
    ~WorldIdentity() = default;

    /// Never 0.
    [[nodiscard]] std::uint64_t number() const { return number_; }

private:
    std::uint64_t number_;
};

struct World {
    WorldIdentity identity;
    ecs::Registry registry;
    Assets assets;
    PlacementOrder placement; ///< of update_world_transforms alone
    glm::vec3 ambient = {
        0.2F, 0.2F, 0.2F}; ///< light that comes from everywhere, relative to the exposure (below)
    float exposure = 1.0F; ///< multiplies light before tone mapping; see render/lighting
};

/// A model whose meshes, materials, textures, skins and clips are in Assets already.
struct ModelAssets {
    Model model; ///< nodes, cameras, lights; its meshes, materials, textures, skins and clips have
                 ///< moved to Assets
    std::uint32_t first_mesh = 0;
    std::uint32_t first_skin = 0;
    std::uint32_t first_clip = 0;
    std::uint32_t clip_count = 0;
};

/// Moves the model's shared parts into `assets`, once per file.
ModelAssets add_assets(Assets& assets, Model&& model);

/// Makes one entity per node (and a root above them) with Transform, WorldTransform, Name, Parent
/// and, as the node asks, MeshInstance, ShadowRole, Skinned, MorphWeights, PosedMesh, Light and
/// Camera. Clips give the root an AnimationPlayer.
/// @param name of the root; nodes are called "name/node", or just "node" when `name` is empty
/// @return the root
ecs::Entity instantiate(World& world, const ModelAssets& model, const std::string& name);

/// Writes WorldTransform from Transform and Parent, parents first; patches only what changed, and
/// gives a WorldTransform to entities that have a Transform alone. A parent that is dead or has no
/// Transform counts as none.
/// @pre no entity is its own ancestor
/// Cost: nothing when nothing changed; else one version look-up per entity, one matrix product per
/// changed one.
void update_world_transforms(World& world);

/// Moves every PathFollower on by dt seconds and writes its Transform.
void advance_paths(World& world, float dt);

/// Advances every AnimationPlayer by dt seconds (0 re-samples) and writes Transforms and
/// MorphWeights.
void advance_animations(World& world, float dt);

/// Poses every skinned or morphed mesh whose joints or weights changed into its PosedMesh. Run it
/// after update_world_transforms. Skinned vertices end in the mesh's own space, so that
/// world_from_local * position is the glTF result (which ignores the node's own transform).
void pose_meshes(World& world);

/// The four above in their order, paths first: what a frame needs before anything reads the world.
void update(World& world, float dt);

/// Bounds of an entity's mesh in the world, posed if it deforms. Empty when it has no mesh.
engine::WorldAabb world_bounds(const World& world, ecs::Entity entity);

/// Bounds of all meshes.
engine::WorldAabb world_bounds(const World& world);

} // namespace scene
