// The node tree of a glTF file: only what the default scene reaches, parents first, with the skins
// that move it.

#include "engine/scene/gltf_reader.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace scene {

namespace {

constexpr std::size_t kMaxNodes = 100'000;
/// A matrix whose columns lean by more than this is told of; less is rounding of exporters.
constexpr double kMaxShear = 1e-3;

using Numbers = std::vector<double>;

engine::Result<void> check_numbers(
    const std::string& place, const char* property, const Numbers& numbers, std::size_t expected) {
    if (!numbers.empty() && numbers.size() != expected)
        return engine::Error{fmt::format(
            "{}: {} has {} numbers, expected {}", place, property, numbers.size(), expected)};
    for (const double number : numbers)
        if (const auto value = bounded(place, property, number); !value) return value.error();
    return {};
}

engine::Result<Transform>
read_transform(GltfReader& reader, const std::string& place, const tinygltf::Node& source) {
    if (const auto checked = check_numbers(place, "matrix", source.matrix, 16); !checked)
        return checked.error();
    if (const auto checked = check_numbers(place, "translation", source.translation, 3); !checked)
        return checked.error();
    if (const auto checked = check_numbers(place, "rotation", source.rotation, 4); !checked)
        return checked.error();
    if (const auto checked = check_numbers(place, "scale", source.scale, 3); !checked)
        return checked.error();

    if (!source.matrix.empty()) {
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = source.matrix[static_cast<std::size_t>(i)];
        const Decomposition parts = decompose(matrix);
        if (parts.shear > kMaxShear)
            reader.warn(fmt::format(
                "{}: its matrix is sheared; the nearest rotation and scale are used", place));
        return parts.transform;
    }
    Transform transform;
    if (!source.translation.empty())
        transform.position = {source.translation[0], source.translation[1], source.translation[2]};
    if (!source.scale.empty())
        transform.scale = glm::dvec3(source.scale[0], source.scale[1], source.scale[2]);
    if (!source.rotation.empty()) {
        const glm::dquat rotation(
            source.rotation[3], source.rotation[0], source.rotation[1], source.rotation[2]);
        const double length = glm::length(rotation);
        if (!(length > 1e-6))
            return engine::Error{place + ": its rotation is zero, expected a unit quaternion"};
        transform.rotation = glm::quat(rotation / length);
    }
    return transform;
}

/// The light that KHR_lights_punctual gives a node.
engine::Result<std::optional<std::uint32_t>>
light_of(const GltfReader& reader, const std::string& place, const tinygltf::Node& source) {
    const auto extension = source.extensions.find("KHR_lights_punctual");
    if (extension == source.extensions.end()) return std::optional<std::uint32_t>();
    const bool given = extension->second.IsObject() && extension->second.Has("light")
                       && extension->second.Get("light").IsInt();
    const int light = given ? extension->second.Get("light").Get<int>() : -1;
    if (light < 0)
        return engine::Error{place + ": KHR_lights_punctual without the number of a light"};
    return optional_index(place, "light", light, reader.model.lights.size());
}

engine::Result<void> read_morph_weights(
    const GltfReader& reader, const std::string& place, const tinygltf::Node& source, Node& node) {
    if (source.weights.empty()) return {};
    const std::size_t targets =
        node.mesh ? reader.model.meshes[*node.mesh].morph_targets.size() : 0;
    if (source.weights.size() != targets)
        return engine::Error{
            fmt::format("{}: {} weights for {} targets", place, source.weights.size(), targets)};
    for (const double weight : source.weights) {
        const auto value = bounded(place, "weights", weight);
        if (!value) return value.error();
        node.morph_weights.push_back(*value);
    }
    return {};
}

engine::Result<Node>
read_node(GltfReader& reader, const std::string& place, const tinygltf::Node& source) {
    Node node;
    const auto transform = read_transform(reader, place, source);
    if (!transform) return transform.error();
    node.local = *transform;
    const auto mesh = optional_index(place, "mesh", source.mesh, reader.model.meshes.size());
    if (!mesh) return mesh.error();
    node.mesh = *mesh;
    const auto skin = optional_index(place, "skin", source.skin, reader.source.skins.size());
    if (!skin) return skin.error();
    node.skin = *skin;
    const auto camera = optional_index(place, "camera", source.camera, reader.cameras.size());
    if (!camera) return camera.error();
    if (*camera) node.camera = reader.cameras[**camera];
    const auto light = light_of(reader, place, source);
    if (!light) return light.error();
    node.light = *light;
    if (const auto read = read_morph_weights(reader, place, source, node); !read)
        return read.error();

    if (node.mesh && reader.model.meshes[*node.mesh].indices.empty()) {
        reader.warn(place + ": its mesh draws nothing and is left out");
        node.mesh.reset();
    }
    if (!node.mesh) {
        node.skin.reset();
        node.morph_weights.clear();
    } else if (const Mesh& found = reader.model.meshes[*node.mesh]; found.deforms()) {
        if (!reader.budget.take(found.positions.size() * 2 * sizeof(glm::vec3)))
            return engine::Error{
                place + ": its posed mesh is more than a model of this size may unpack"};
    }
    return node;
}

/// Nodes that the default scene names; without a scene, all that are nobody's children.
engine::Result<std::vector<int>> root_nodes(const tinygltf::Model& source) {
    if (!source.scenes.empty()) {
        const int scene = std::max(source.defaultScene, 0);
        if (static_cast<std::size_t>(scene) >= source.scenes.size())
            return engine::Error{
                fmt::format("scene {} of {} does not exist", scene, source.scenes.size())};
        return source.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<char> is_child(source.nodes.size());
    for (const tinygltf::Node& node : source.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < source.nodes.size())
                is_child[static_cast<std::size_t>(child)] = 1;
    std::vector<int> roots;
    for (std::size_t i = 0; i < source.nodes.size(); ++i)
        if (is_child[i] == 0) roots.push_back(static_cast<int>(i));
    return roots;
}

/// "Cube", "Cube.001" ...: the name itself, or with the first number that nobody has yet.
class UniqueNames {
public:
    std::string take(const std::string& wanted) {
        std::string name = wanted;
        for (int& number = next_[wanted]; !taken_.insert(name).second;)
            name = fmt::format("{}.{:03}", wanted, ++number);
        return name;
    }

private:
    std::unordered_set<std::string> taken_;
    std::unordered_map<std::string, int> next_;
};

} // namespace

engine::Result<void> read_nodes(GltfReader& reader) {
    struct Waiting {
        int node;
        std::optional<std::uint32_t> parent;
    };
    const tinygltf::Model& source = reader.source;
    if (source.nodes.size() > kMaxNodes)
        return engine::Error{
            fmt::format("{} nodes, expected at most {}", source.nodes.size(), kMaxNodes)};
    const auto roots = root_nodes(source);
    if (!roots) return roots.error();
    std::vector<Waiting> waiting;
    for (auto root = roots->rbegin(); root != roots->rend(); ++root)
        waiting.push_back({*root, std::nullopt});

    reader.nodes.assign(source.nodes.size(), std::nullopt);
    UniqueNames names;
    while (!waiting.empty()) {
        const Waiting next = waiting.back();
        waiting.pop_back();
        if (next.node < 0 || static_cast<std::size_t>(next.node) >= source.nodes.size())
            return engine::Error{
                fmt::format("node {} of {} does not exist", next.node, source.nodes.size())};
        const auto index = static_cast<std::size_t>(next.node);
        const tinygltf::Node& found = source.nodes[index];
        const std::string place = label("node", index, found.name);
        if (reader.nodes[index])
            return engine::Error{
                place + ": is its own ancestor or has two parents, expected a tree"};
        auto node = read_node(reader, place, found);
        if (!node) return node.error();
        node->name = names.take(found.name.empty() ? fmt::format("node {}", index) : found.name);
        node->parent = next.parent;

        const auto made = static_cast<std::uint32_t>(reader.model.nodes.size());
        reader.nodes[index] = made;
        reader.model.nodes.push_back(std::move(*node));
        for (auto child = found.children.rbegin(); child != found.children.rend(); ++child)
            waiting.push_back({*child, made});
    }
    return {};
}

} // namespace scene
