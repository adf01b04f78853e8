// Meshes out of glTF: the attributes of each primitive are read and checked, then joined into one
// Mesh.

#include "engine/scene/gltf_primitive.hpp"
#include "engine/scene/gltf_reader.hpp"
#include "engine/scene/primitives.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace scene {

namespace {

using Attributes = std::map<std::string, int>;

/// -1 where there is none; any other negative number is an accessor that does not exist.
std::optional<int> find(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::nullopt : std::optional(found->second);
}

/// An attribute that may be absent: empty then, else one vector per vertex.
/// Errors: as AccessorReader::floats, and a count other than `count`.
template <class Vec>
engine::Result<std::vector<Vec>> read_attribute(
    const GltfReader& reader,
    const std::string& place,
    const Attributes& attributes,
    const std::string& name,
    std::size_t count) {
    const auto accessor = find(attributes, name);
    if (!accessor) return std::vector<Vec>();
    // Normals that are no numbers are mended later.
    const auto numbers = name == "NORMAL"
                             ? reader.accessors.floats_as_found(*accessor, Vec::length())
                             : reader.accessors.floats(*accessor, Vec::length());
    if (!numbers) return at(place + " " + name, numbers.error());
    auto vectors = as_vectors<Vec>(*numbers);
    if (vectors.size() != count)
        return engine::Error{
            fmt::format("{} {}: {} elements for {} vertices", place, name, vectors.size(), count)};
    return vectors;
}

engine::Result<std::vector<JointInfluence>> read_influences(
    GltfReader& reader, const std::string& place, const Attributes& attributes, std::size_t count) {
    const auto joints_accessor = find(attributes, "JOINTS_0");
    if (!joints_accessor || !attributes.contains("WEIGHTS_0")) {
        if (joints_accessor || attributes.contains("WEIGHTS_0"))
            reader.warn(place + ": joints without weights, or the reverse, are ignored");
        return std::vector<JointInfluence>();
    }
    const auto joints = reader.accessors.integers(*joints_accessor, 4);
    if (!joints) return at(place + " JOINTS_0", joints.error());
    if (joints->size() != 4 * count)
        return engine::Error{fmt::format(
            "{} JOINTS_0: {} elements for {} vertices", place, joints->size() / 4, count)};
    const auto weights = read_attribute<glm::vec4>(reader, place, attributes, "WEIGHTS_0", count);
    if (!weights) return weights.error();
    if (attributes.contains("JOINTS_1"))
        reader.warn(place + ": only four joints move a vertex; the others are ignored");

    std::vector<JointInfluence> influences(count);
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec4 weight = glm::max((*weights)[i], glm::vec4(0.0F));
        const float sum = weight.x + weight.y + weight.z + weight.w;
        weight = sum > 1e-6F ? weight / sum : glm::vec4(1.0F, 0.0F, 0.0F, 0.0F);
        for (std::size_t k = 0; k < 4; ++k) {
            if (weight[static_cast<int>(k)] == 0.0F) continue;
            const std::uint32_t joint = (*joints)[4 * i + k];
            if (joint > std::numeric_limits<std::uint16_t>::max())
                return engine::Error{fmt::format(
                    "{} JOINTS_0: joint {} at vertex {} is past 65535", place, joint, i)};
            influences[i].joints[k] = static_cast<std::uint16_t>(joint);
        }
        influences[i].weights = weight;
    }
    return influences;
}

engine::Result<std::vector<std::uint32_t>> read_indices(
    const GltfReader& reader, const std::string& place, int accessor, std::size_t vertex_count) {
    if (accessor < 0) {
        std::vector<std::uint32_t> all(vertex_count);
        std::iota(all.begin(), all.end(), 0U);
        return all;
    }
    auto indices = reader.accessors.integers(accessor, 1);
    if (!indices) return at(place + " indices", indices.error());
    for (std::size_t i = 0; i < indices->size(); ++i)
        if ((*indices)[i] >= vertex_count)
            return engine::Error{fmt::format(
                "{}: index {} at {} is past its {} vertices",
                place,
                (*indices)[i],
                i,
                vertex_count)};
    return indices;
}

engine::Result<void> read_morph_targets(
    const GltfReader& reader,
    const std::string& place,
    const tinygltf::Primitive& source,
    PrimitiveData& data) {
    for (std::size_t i = 0; i < source.targets.size(); ++i) {
        const std::string target_place = fmt::format("{} target {}", place, i);
        auto positions = read_attribute<glm::vec3>(
            reader, target_place, source.targets[i], "POSITION", data.positions.size());
        if (!positions) return positions.error();
        auto normals = read_attribute<glm::vec3>(
            reader, target_place, source.targets[i], "NORMAL", data.positions.size());
        if (!normals) return normals.error();
        for (glm::vec3& delta : *normals)
            if (!(glm::length(glm::dvec3(delta)) <= kLargestNumber)) delta = {};
        data.morph_targets.push_back({std::move(*positions), std::move(*normals)});
    }
    return {};
}

/// Bytes of a vertex with all that belongs to it.
std::uint64_t vertex_bytes(const PrimitiveData& data) {
    return 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(JointInfluence)
           + data.morph_targets.size() * 2 * sizeof(glm::vec3);
}

engine::Result<void> read_normals(
    GltfReader& reader,
    const std::string& place,
    const tinygltf::Primitive& source,
    PrimitiveData& data) {
    auto normals = read_attribute<glm::vec3>(
        reader, place, source.attributes, "NORMAL", data.positions.size());
    if (!normals) return normals.error();
    data.normals = std::move(*normals);
    if (!data.normals.empty()) {
        if (const std::size_t mended = mend_normals(data); mended > 0)
            reader.warn(fmt::format(
                "{}: {} normals were not of length 1 and are made anew", place, mended));
    } else if (data.topology == Topology::triangles) {
        if (!reader.budget.take(data.indices.size() * vertex_bytes(data)))
            return engine::Error{fmt::format(
                "{}: {} indices are more than a model of this size may unpack",
                place,
                data.indices.size())};
        make_flat(data);
    } else {
        data.normals.assign(data.positions.size(), {0.0F, 1.0F, 0.0F});
    }
    return {};
}

/// @return none for a primitive that draws nothing
engine::Result<std::optional<PrimitiveData>> read_primitive(
    GltfReader& reader, const std::string& place, const tinygltf::Primitive& source, int uv_set) {
    const auto accessor = find(source.attributes, "POSITION");
    if (!accessor) {
        reader.warn(place + ": has no positions and is left out");
        return std::optional<PrimitiveData>();
    }
    const auto positions = reader.accessors.floats(*accessor, 3);
    if (!positions) return at(place + " POSITION", positions.error());
    PrimitiveData data;
    data.positions = as_vectors<glm::vec3>(*positions);

    const auto indices = read_indices(reader, place, source.indices, data.positions.size());
    if (!indices) return indices.error();
    if (!reader.budget.take(3 * sizeof(std::uint32_t) * indices->size()))
        return engine::Error{fmt::format(
            "{}: {} indices are more than a model of this size may unpack",
            place,
            indices->size())};
    auto list = list_indices(source.mode, *indices);
    if (!list) return engine::Error{fmt::format("{}: mode {} is not known", place, source.mode)};
    data.topology = list->topology;
    data.indices = std::move(list->indices);

    auto uvs = read_attribute<glm::vec2>(
        reader,
        place,
        source.attributes,
        fmt::format("TEXCOORD_{}", uv_set),
        data.positions.size());
    if (!uvs) return uvs.error();
    data.uvs = std::move(*uvs);
    auto influences = read_influences(reader, place, source.attributes, data.positions.size());
    if (!influences) return influences.error();
    data.influences = std::move(*influences);
    if (source.attributes.contains("COLOR_0")) reader.warn(place + ": vertex colours are ignored");
    if (const auto read = read_morph_targets(reader, place, source, data); !read)
        return read.error();
    if (const auto read = read_normals(reader, place, source, data); !read) return read.error();
    return std::optional(std::move(data));
}

/// Appends values, or as many defaults, when any primitive of the mesh has them.
template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t first, std::size_t count) {
    if (from.empty() && to.empty()) return;
    to.resize(first);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(first + count);
}

/// Bytes that the morph targets of a mesh grow by: each has an offset for every vertex of every
/// primitive.
std::uint64_t morph_bytes(const Mesh& mesh, const PrimitiveData& data) {
    const std::uint64_t before = mesh.morph_targets.size();
    const std::uint64_t after = std::max(mesh.morph_targets.size(), data.morph_targets.size());
    return 2 * sizeof(glm::vec3)
           * (after * data.positions.size() + (after - before) * mesh.positions.size());
}

void append_primitive(Mesh& mesh, const PrimitiveData& data, std::uint32_t material) {
    const std::size_t first = mesh.positions.size();
    const std::size_t count = data.positions.size();
    append(mesh.positions, data.positions, first, count);
    append(mesh.normals, data.normals, first, count);
    append(mesh.uvs, data.uvs, first, count);
    append(mesh.influences, data.influences, first, count);
    mesh.morph_targets.resize(std::max(mesh.morph_targets.size(), data.morph_targets.size()));
    for (std::size_t i = 0; i < mesh.morph_targets.size(); ++i) {
        const MorphTarget target =
            i < data.morph_targets.size() ? data.morph_targets[i] : MorphTarget{};
        MorphTarget& to = mesh.morph_targets[i];
        append(to.position_deltas, target.position_deltas, first, count);
        append(to.normal_deltas, target.normal_deltas, first, count);
    }
    mesh.submeshes.push_back(
        {data.topology,
         static_cast<std::uint32_t>(mesh.indices.size()),
         static_cast<std::uint32_t>(data.indices.size()),
         material});
    for (const std::uint32_t index : data.indices)
        mesh.indices.push_back(static_cast<std::uint32_t>(first) + index);
}

/// Arrays that earlier or later primitives lack get their defaults up to the last vertex.
void complete(Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    if (!mesh.uvs.empty()) mesh.uvs.resize(count);
    if (!mesh.influences.empty()) mesh.influences.resize(count);
    for (MorphTarget& target : mesh.morph_targets) {
        target.position_deltas.resize(count);
        if (!target.normal_deltas.empty()) target.normal_deltas.resize(count);
    }
}

engine::Result<void>
read_weights(const std::string& place, const tinygltf::Mesh& source, Mesh& mesh) {
    mesh.morph_weights.assign(mesh.morph_targets.size(), 0.0F);
    if (!source.weights.empty() && source.weights.size() != mesh.morph_targets.size())
        return engine::Error{fmt::format(
            "{}: {} weights for {} targets",
            place,
            source.weights.size(),
            mesh.morph_targets.size())};
    for (std::size_t i = 0; i < source.weights.size(); ++i) {
        const auto weight = bounded(place, "weights", source.weights[i]);
        if (!weight) return weight.error();
        mesh.morph_weights[i] = *weight;
    }
    return {};
}

/// Index of a white material, made when it is first needed.
std::uint32_t default_material(Model& model, std::optional<std::uint32_t>& known) {
    if (!known) {
        known = static_cast<std::uint32_t>(model.materials.size());
        model.materials.push_back({.name = "default"});
    }
    return *known;
}

} // namespace

engine::Result<void> read_meshes(GltfReader& reader) {
    std::optional<std::uint32_t> white;
    for (std::size_t i = 0; i < reader.source.meshes.size(); ++i) {
        const tinygltf::Mesh& source = reader.source.meshes[i];
        const std::string place = label("mesh", i, source.name);
        Mesh mesh;
        mesh.name = source.name;
        for (std::size_t k = 0; k < source.primitives.size(); ++k) {
            const tinygltf::Primitive& primitive = source.primitives[k];
            const std::string primitive_place = fmt::format("{} primitive {}", place, k);
            const auto material = optional_index(
                primitive_place, "material", primitive.material, reader.uv_sets.size());
            if (!material) return material.error();
            const auto data = read_primitive(
                reader, primitive_place, primitive, *material ? reader.uv_sets[**material] : 0);
            if (!data) return data.error();
            if (!*data || (*data)->indices.empty()) continue;
            if (!reader.budget.take(morph_bytes(mesh, **data)))
                return engine::Error{fmt::format(
                    "{}: its targets are more than a model of this size may unpack",
                    primitive_place)};
            append_primitive(
                mesh, **data, *material ? **material : default_material(reader.model, white));
        }
        complete(mesh);
        if (const auto read = read_weights(place, source, mesh); !read) return read.error();
        if (!mesh.indices.empty()) finish_mesh(mesh);
        reader.model.meshes.push_back(std::move(mesh));
    }
    if (reader.model.materials.empty()) default_material(reader.model, white);
    return {};
}

} // namespace scene
