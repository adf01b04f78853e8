// Skins out of glTF, after the nodes that they name.

#include "engine/scene/gltf_reader.hpp"

#include <algorithm>

namespace scene {

namespace {

engine::Result<Skin>
read_skin(GltfReader& reader, const std::string& place, const tinygltf::Skin& source) {
    Skin skin;
    skin.name = source.name;
    for (const int joint : source.joints) {
        if (joint < 0 || static_cast<std::size_t>(joint) >= reader.nodes.size())
            return engine::Error{fmt::format(
                "{}: joint node {} of {} does not exist", place, joint, reader.nodes.size())};
        const auto node = reader.nodes[static_cast<std::size_t>(joint)];
        if (!node)
            return engine::Error{
                fmt::format("{}: joint node {} is not in the scene", place, joint)};
        skin.joints.push_back(*node);
    }
    if (source.inverseBindMatrices < 0) {
        skin.joint_from_mesh.assign(skin.joints.size(), glm::mat4(1.0F));
        return skin;
    }
    const auto numbers = reader.accessors.floats(source.inverseBindMatrices, 16);
    if (!numbers) return at(place + " inverse bind matrices", numbers.error());
    if (numbers->size() / 16 < skin.joints.size())
        return engine::Error{fmt::format(
            "{}: {} inverse bind matrices for {} joints",
            place,
            numbers->size() / 16,
            skin.joints.size())};
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        glm::mat4 matrix;
        for (int k = 0; k < 16; ++k)
            matrix[k / 4][k % 4] = (*numbers)[16 * i + static_cast<std::size_t>(k)];
        for (int column = 0; column < 4; ++column)
            matrix[column][3] = column == 3 ? 1.0F : 0.0F; // affine, whatever rounding left there
        skin.joint_from_mesh.push_back(matrix);
    }
    return skin;
}

/// Whether every joint that moves a vertex of the mesh is in the skin.
engine::Result<void> check_joints(const Node& node, const Mesh& mesh, const Skin& skin) {
    for (std::size_t i = 0; i < mesh.influences.size(); ++i)
        for (const std::uint16_t joint : mesh.influences[i].joints)
            if (joint >= skin.joints.size())
                return engine::Error{fmt::format(
                    "node '{}': joint {} at vertex {} is past the {} joints of its skin",
                    node.name,
                    joint,
                    i,
                    skin.joints.size())};
    return {};
}

} // namespace

engine::Result<void> read_skins(GltfReader& reader) {
    // A skin that no node of the scene wears may name nodes outside the scene: it is left empty.
    std::vector<char> worn(reader.source.skins.size());
    for (const Node& node : reader.model.nodes)
        if (node.skin) worn[*node.skin] = 1;
    for (std::size_t i = 0; i < reader.source.skins.size(); ++i) {
        const tinygltf::Skin& source = reader.source.skins[i];
        auto skin = worn[i] != 0 ? read_skin(reader, label("skin", i, source.name), source)
                                 : Skin{source.name, {}, {}};
        if (!skin) return skin.error();
        reader.model.skins.push_back(std::move(*skin));
    }
    for (Node& node : reader.model.nodes) {
        if (!node.skin) continue;
        const Mesh& mesh = reader.model.meshes[*node.mesh];
        if (mesh.influences.empty()) {
            reader.warn(fmt::format(
                "node '{}': has a skin, but its mesh has no joints; it moves as one", node.name));
            node.skin.reset();
        } else if (const auto checked = check_joints(node, mesh, reader.model.skins[*node.skin]);
                   !checked) {
            return checked.error();
        }
    }
    return {};
}

} // namespace scene
