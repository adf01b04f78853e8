#include "engine/gpu/vertex_array.hpp"

#include "engine/core/check.hpp"

#include <array>

namespace gpu {

namespace {

struct ComponentTraits {
    GLenum type;
    bool normalised;
    bool integer;
};

const ComponentTraits& component_traits(Component component) {
    static constexpr std::array<ComponentTraits, 9> kTraits = {{
        {GL_FLOAT, false, false},
        {GL_UNSIGNED_BYTE, true, false},
        {GL_BYTE, true, false},
        {GL_UNSIGNED_SHORT, true, false},
        {GL_SHORT, true, false},
        {GL_UNSIGNED_BYTE, false, true},
        {GL_UNSIGNED_SHORT, false, true},
        {GL_UNSIGNED_INT, false, true},
        {GL_INT, false, true},
    }};
    return kTraits[static_cast<std::size_t>(component)];
}

void add_attribute(GLuint vertex_array, GLuint stream, const VertexAttribute& attribute) {
    const ComponentTraits& format = component_traits(attribute.type);
    glEnableVertexArrayAttrib(vertex_array, attribute.location);
    glVertexArrayAttribBinding(vertex_array, attribute.location, stream);
    if (format.integer) {
        glVertexArrayAttribIFormat(
            vertex_array,
            attribute.location,
            attribute.components,
            format.type,
            attribute.offset_bytes);
    } else {
        glVertexArrayAttribFormat(
            vertex_array,
            attribute.location,
            attribute.components,
            format.type,
            format.normalised ? GL_TRUE : GL_FALSE,
            attribute.offset_bytes);
    }
}

} // namespace

VertexArray::VertexArray(
    std::string_view label, std::span<const VertexStream> streams, const Buffer* indices)
    : indexed_(indices != nullptr) {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    handle_ = VertexArrayHandle(name);
    label_object(GL_VERTEX_ARRAY, name, label);
    GLuint binding = 0;
    for (const VertexStream& stream : streams) {
        CHECK(stream.buffer != nullptr);
        glVertexArrayVertexBuffer(
            name,
            binding,
            stream.buffer->name(),
            static_cast<GLintptr>(stream.offset_bytes),
            stream.stride_bytes);
        glVertexArrayBindingDivisor(name, binding, stream.per_instance ? 1 : 0);
        for (const VertexAttribute& attribute : stream.attributes) {
            add_attribute(name, binding, attribute);
        }
        ++binding;
    }
    if (indices != nullptr) glVertexArrayElementBuffer(name, indices->name());
}

VertexArray VertexArray::none() {
    return VertexArray("no attributes", {});
}

} // namespace gpu
