// A model file in memory: what glTF gave, checked, before it becomes entities.

#pragma once

#include "engine/scene/animation_clip.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/material.hpp"
#include "engine/scene/mesh.hpp"
#include "engine/scene/transform.hpp"

#include <optional>
#include <string>
#include <vector>

namespace scene {

/// Joints of a skin, as node indices, with the matrices that take mesh space to each joint's bind
/// space.
struct Skin {
    std::string name;
    std::vector<std::uint32_t> joints;      ///< indices into Model::nodes
    std::vector<glm::mat4> joint_from_mesh; ///< inverse bind matrices, one per joint
};

struct Node {
    std::string name; ///< unique within the model; made up where the file gave none
    std::optional<std::uint32_t> parent; ///< index < this node's own: parents come first
    Transform local;
    std::optional<std::uint32_t> mesh;
    std::optional<std::uint32_t> skin;
    std::optional<std::uint32_t> camera;
    std::optional<std::uint32_t> light;
    std::vector<float> morph_weights; ///< empty: the mesh's own
};

struct Model {
    std::string file;
    std::vector<Mesh> meshes;
    std::vector<Material> materials; ///< at least one: [0] is white where the file has none
    std::vector<Texture> textures;
    std::vector<Node> nodes; ///< parents before children; only nodes of the default scene
    std::vector<Skin> skins;
    std::vector<AnimationClip> clips;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<std::string> warnings; ///< one sentence each, with the place in the file
};

} // namespace scene
