// What the parts of the glTF reader share: the parsed file, the model that grows from it, and small
// helpers.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/accessor.hpp"
#include "engine/scene/model.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace scene {

/// "mesh 'Box'" or "mesh 3": how errors and warnings name a part of the file.
inline std::string label(const char* kind, std::size_t index, const std::string& name) {
    return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("{} '{}'", kind, name);
}

struct GltfReader {
    /// @param file_bytes of the file and all it refers to
    GltfReader(const tinygltf::Model& parsed, Model& made, std::uint64_t file_bytes)
        : source(parsed),
          model(made),
          budget((16U << 20U) + 64 * file_bytes),
          pictures((256U << 20U) + 4096 * file_bytes),
          accessors(parsed, budget) {}

    const tinygltf::Model& source;
    Model& model;
    MemoryBudget budget;   ///< of numbers: geometry and animations
    MemoryBudget pictures; ///< of pixels, which compress better
    AccessorReader accessors;

    /// Texture coordinate set that each material of the file asks for.
    std::vector<int> uv_sets;
    /// Model camera of each camera of the file; none for orthographic ones.
    std::vector<std::optional<std::uint32_t>> cameras;
    /// Model node of each node of the file; none outside the default scene.
    std::vector<std::optional<std::uint32_t>> nodes;

    void warn(std::string sentence) { model.warnings.push_back(std::move(sentence)); }
};

/// "place: message".
inline engine::Error at(const std::string& place, const engine::Error& error) {
    return engine::Error{place + ": " + error.message};
}

/// Errors: an index that names nothing. @param index negative where the file has none
inline engine::Result<std::optional<std::uint32_t>>
optional_index(const std::string& place, const char* kind, int index, std::size_t count) {
    if (index < 0) return std::optional<std::uint32_t>();
    if (static_cast<std::size_t>(index) >= count)
        return engine::Error{
            fmt::format("{}: {} {} of {} does not exist", place, kind, index, count)};
    return std::optional(static_cast<std::uint32_t>(index));
}

/// A number from the JSON as a float.
/// Errors: not finite or outside [low, high].
engine::Result<float> bounded(
    const std::string& place,
    const char* property,
    double value,
    double low = -kLargestNumber,
    double high = kLargestNumber);

// The parts, in the order in which they must run. Errors: the first number that is out of its
// range.
engine::Result<void> read_materials(GltfReader& reader);
engine::Result<void> read_meshes(GltfReader& reader);
engine::Result<void> read_cameras_and_lights(GltfReader& reader);
engine::Result<void> read_nodes(GltfReader& reader);
engine::Result<void> read_skins(GltfReader& reader);
engine::Result<void> read_animations(GltfReader& reader);

/// Whether doubles and floats hold every place that nodes can reach, at rest and in every clip.
/// Errors: scales or translations that multiply beyond that; the sentence names the node.
engine::Result<void> check_reach(const Model& model);

} // namespace scene
