#include "engine/gpu/buffer.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <bit>

namespace gpu {

namespace {

GLuint new_buffer(std::string_view label) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    label_object(GL_BUFFER, name, label);
    return name;
}

// OpenGL has no buffers of zero bytes.
constexpr std::size_t kLeastBytes = 16;

} // namespace

Buffer Buffer::fixed(std::string_view label, std::span<const std::byte> contents) {
    Buffer buffer;
    buffer.handle_ = BufferHandle(new_buffer(label));
    buffer.size_bytes_ = contents.size();
    buffer.device_bytes_ = DeviceBytes(std::max(contents.size(), kLeastBytes));
    const void* data = contents.size() < kLeastBytes ? nullptr : contents.data();
    const GLbitfield flags = data == nullptr ? GL_DYNAMIC_STORAGE_BIT : 0;
    glNamedBufferStorage(
        buffer.name(), static_cast<GLsizeiptr>(buffer.capacity_bytes()), data, flags);
    if (data == nullptr && !contents.empty()) {
        glNamedBufferSubData(
            buffer.name(), 0, static_cast<GLsizeiptr>(contents.size()), contents.data());
    }
    return buffer;
}

Buffer Buffer::dynamic(std::string_view label, std::size_t size_bytes) {
    Buffer buffer;
    buffer.handle_ = BufferHandle(new_buffer(label));
    buffer.dynamic_ = true;
    buffer.size_bytes_ = size_bytes;
    buffer.device_bytes_ = DeviceBytes(std::max(size_bytes, kLeastBytes));
    glNamedBufferData(
        buffer.name(), static_cast<GLsizeiptr>(buffer.capacity_bytes()), nullptr, GL_DYNAMIC_DRAW);
    return buffer;
}

void Buffer::assign(std::span<const std::byte> contents) {
    CHECK(dynamic_);
    if (contents.size() > capacity_bytes())
        device_bytes_ = DeviceBytes(std::bit_ceil(contents.size()));
    size_bytes_ = contents.size();
    // A new store each time: the driver keeps the old one until the draws that read it are done.
    glNamedBufferData(name(), static_cast<GLsizeiptr>(capacity_bytes()), nullptr, GL_DYNAMIC_DRAW);
    if (!contents.empty()) {
        glNamedBufferSubData(name(), 0, static_cast<GLsizeiptr>(contents.size()), contents.data());
    }
}

void Buffer::write(std::size_t offset_bytes, std::span<const std::byte> contents) {
    CHECK(dynamic_);
    CHECK_LE(offset_bytes + contents.size(), capacity_bytes());
    size_bytes_ = std::max(size_bytes_, offset_bytes + contents.size());
    glNamedBufferSubData(
        name(),
        static_cast<GLintptr>(offset_bytes),
        static_cast<GLsizeiptr>(contents.size()),
        contents.data());
}

void Buffer::clear() {
    CHECK(dynamic_);
    glClearNamedBufferData(name(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
}

void Buffer::bind_uniform(unsigned binding) const {
    CHECK(handle_);
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, name());
}

void Buffer::bind_uniform(
    unsigned binding, std::size_t offset_bytes, std::size_t size_bytes) const {
    CHECK(handle_);
    glBindBufferRange(
        GL_UNIFORM_BUFFER,
        binding,
        name(),
        static_cast<GLintptr>(offset_bytes),
        static_cast<GLsizeiptr>(size_bytes));
}

void Buffer::bind_storage(unsigned binding) const {
    CHECK(handle_);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name());
}

void Buffer::read(std::span<std::byte> contents, std::size_t offset_bytes) const {
    CHECK(handle_);
    CHECK_LE(offset_bytes + contents.size(), capacity_bytes());
    glGetNamedBufferSubData(
        name(),
        static_cast<GLintptr>(offset_bytes),
        static_cast<GLsizeiptr>(contents.size()),
        contents.data());
}

} // namespace gpu
