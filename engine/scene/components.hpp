// Components that scenes are made of, besides Transform, WorldTransform, Light and Camera. Plain
// data.

#pragma once

#include "ecs/entity.hpp"
#include "engine/core/geometry.hpp"
#include "engine/scene/transform.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scene {

struct Model;

/// What people call the entity; unique within a world.
struct Name {
    std::string text;
};

struct Parent {
    ecs::Entity entity;
};

/// Draws a mesh of Assets.
struct MeshInstance {
    std::uint32_t mesh = 0; ///< index into Assets::meshes
};

/// How an entity takes part in shadows.
struct ShadowRole {
    bool casts = true;
    bool receives = true;
    bool hero = false;
};

/// Vertices of a mesh that deforms, in mesh space, as posed for this frame. Geometry, volumes, maps
/// and truth all read these; nothing else deforms anything.
struct PosedMesh {
    std::vector<glm::vec3> positions; ///< one per vertex of the mesh
    std::vector<glm::vec3> normals;   ///< unit, one per vertex
    engine::Aabb bounds;
};

/// Moves a MeshInstance by joints.
struct Skinned {
    std::uint32_t skin = 0;          ///< index into Assets::skins
    std::vector<ecs::Entity> joints; ///< in the order of the skin
};

/// Weights of the morph targets of a MeshInstance.
struct MorphWeights {
    std::vector<float> weights;
};

/// Plays one clip of a model on the entities made from its nodes. Sits on the root entity of the
/// instance.
struct AnimationPlayer {
    std::uint32_t first_clip = 0; ///< index into Assets::clips of this model's first clip
    std::uint32_t clip_count = 0;
    std::uint32_t clip = 0; ///< 0 .. clip_count - 1
    float time = 0.0F;      ///< seconds
    float speed = 1.0F;     ///< 1 is as authored, 0 stands still
    bool loops = true;
    std::vector<ecs::Entity> nodes; ///< entity of each Model node
};

/// Goes along a path of Assets, looking (with its +Z side) the way it goes.
struct PathFollower {
    std::uint32_t path = 0; ///< index into Assets::paths
    double travelled = 0.0; ///< metres from the first point
    float speed = 1.2F;     ///< m/s; negative goes backwards
};

} // namespace scene
