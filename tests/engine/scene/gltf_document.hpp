// Small glTF files made in memory, to be bent and broken by tests.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/model.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace testing_gltf {

/// A glTF document whose one buffer is kept beside the JSON and written as a data URI.
struct Document {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::vector<std::uint8_t> buffer;

    /// Appends to an array of the root ("meshes", "nodes" ...). @return the index there
    int add(const char* array, const nlohmann::json& value);

    /// Appends numbers, a buffer view of them and an accessor.
    /// @param type "SCALAR", "VEC3" ...; @param components of that type
    template <class T>
    int accessor(const char* type, std::size_t components, const std::vector<T>& numbers);

    /// A buffer view of its own. @return its index
    int view(const void* bytes, std::size_t count);

    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::vector<std::uint8_t> binary() const; ///< as .glb
    [[nodiscard]] engine::Result<scene::Model> load() const;
};

/// One white triangle (0,0,0) (1,0,0) (0,1,0) with unit normals along +Z in one node of one scene.
/// Accessors: 0 positions, 1 normals, 2 indices.
Document triangle();

/// @pre it loads; else the test fails and an empty model comes back
scene::Model loaded(const Document& document);

template <class T>
constexpr int component_type() {
    if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
    return 5126;
}

template <class T>
int Document::accessor(const char* type, std::size_t components, const std::vector<T>& numbers) {
    const int bytes = view(numbers.data(), numbers.size() * sizeof(T));
    return add(
        "accessors",
        {{"bufferView", bytes},
         {"componentType", component_type<T>()},
         {"count", numbers.size() / components},
         {"type", type}});
}

} // namespace testing_gltf
