// Where a draw finds its vertices and indices.

#pragma once

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/handle.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace gpu {

/// How one component of an attribute is stored. The normalised ones arrive in the shader as floats
/// in [0, 1] or [-1, 1], the plain integers as ints.
enum class Component : std::uint8_t { f32, unorm8, snorm8, unorm16, snorm16, u8, u16, u32, i32 };

/// One shader input. A mat4 takes four locations, so four attributes.
struct VertexAttribute {
    unsigned location = 0;
    int components = 3; ///< 1 to 4
    Component type = Component::f32;
    unsigned offset_bytes = 0; ///< within one element of the stream
};

/// A buffer of elements, one per vertex or one per instance.
struct VertexStream {
    const Buffer* buffer = nullptr; ///< must outlive the vertex array's last use
    int stride_bytes = 0;
    std::vector<VertexAttribute> attributes = {};
    bool per_instance = false;
    std::size_t offset_bytes = 0; ///< of the first element
};

/// Empty when default constructed: for draws whose shader makes its own vertices use none().
class VertexArray {
public:
    VertexArray() = default;

    /// @param indices 32-bit, or null for draws without
    VertexArray(
        std::string_view label,
        std::span<const VertexStream> streams,
        const Buffer* indices = nullptr);

    /// No attributes at all: gl_VertexID is all that the shader gets.
    static VertexArray none();

    [[nodiscard]] GLuint name() const { return handle_.name(); }
    [[nodiscard]] bool indexed() const { return indexed_; }

private:
    VertexArrayHandle handle_;
    bool indexed_ = false;
};

} // namespace gpu
