// Numbers out of glTF accessors: every component type, normalised, strided and sparse. Nothing is
// read or allocated before its place and size are checked.

#pragma once

#include "engine/core/result.hpp"

#include <glm/glm.hpp>
#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scene {

/// Larger numbers have no place in a scene, and their squares and products no place in a float.
inline constexpr double kLargestNumber = 1e9;

/// Bytes that a model may still unpack. Accessors can be shared, sparse or empty, so a small file
/// can ask for far more memory than it has bytes.
class MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t bytes) : left_(bytes) {}

    /// False when that is more than what is left.
    [[nodiscard]] bool take(std::uint64_t bytes) {
        if (bytes > left_) return false;
        left_ -= bytes;
        return true;
    }

private:
    std::uint64_t left_;
};

/// The bytes of a buffer view.
/// Errors: no such view or buffer, or a view past the end of its buffer.
engine::Result<std::span<const std::uint8_t>> view_bytes(const tinygltf::Model& source, int view);

class AccessorReader {
public:
    AccessorReader(const tinygltf::Model& source, MemoryBudget& budget)
        : source_(&source),
          budget_(&budget) {}

    /// @param width components per element: 1 to 4, or 16 for a 4x4 matrix
    /// @return element after element; integers as they are, or in [-1, 1] or [0, 1] when the
    /// accessor is normalised Errors: no such accessor, not of that width, not in its buffer, or
    /// with an element that is not finite or beyond kLargestNumber.
    [[nodiscard]] engine::Result<std::vector<float>> floats(int accessor, int width) const;

    /// The same, but elements may be anything.
    [[nodiscard]] engine::Result<std::vector<float>> floats_as_found(int accessor, int width) const;

    /// The same for unsigned 8, 16 and 32-bit integers.
    /// Errors: also other component types.
    [[nodiscard]] engine::Result<std::vector<std::uint32_t>>
    integers(int accessor, int width) const;

private:
    template <class T>
    [[nodiscard]] engine::Result<std::vector<T>> read(int accessor, int width) const;

    const tinygltf::Model* source_;
    MemoryBudget* budget_;
};

/// Numbers as vectors. @param numbers count divisible by the length of Vec
template <class Vec>
std::vector<Vec> as_vectors(const std::vector<float>& numbers) {
    constexpr auto kLength = static_cast<std::size_t>(Vec::length());
    std::vector<Vec> vectors(numbers.size() / kLength);
    for (std::size_t i = 0; i < vectors.size() * kLength; ++i)
        vectors[i / kLength][static_cast<glm::length_t>(i % kLength)] = numbers[i];
    return vectors;
}

} // namespace scene
