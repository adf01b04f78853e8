// Owners of OpenGL names, and the count of bytes that live on the device.

#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace gpu {

/// Sole owner of one OpenGL name; deletes it on destruction. Movable, not copyable; 0 owns nothing.
/// Traits::destroy is a function, not a template argument, because libepoxy's gl* are macros.
template <class Traits>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        Handle(std::move(other)).swap(*this);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (name_ != 0) Traits::destroy(name_);
    }

    void swap(Handle& other) noexcept { std::swap(name_, other.name_); }
    [[nodiscard]] GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    GLuint name_ = 0;
};

struct BufferTraits {
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct TextureTraits {
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct SamplerTraits {
    static void destroy(GLuint name) { glDeleteSamplers(1, &name); }
};
struct FramebufferTraits {
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayTraits {
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct QueryTraits {
    static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};
struct ShaderTraits {
    static void destroy(GLuint name) { glDeleteShader(name); }
};
struct ProgramTraits {
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using BufferHandle = Handle<BufferTraits>;
using TextureHandle = Handle<TextureTraits>;
using SamplerHandle = Handle<SamplerTraits>;
using FramebufferHandle = Handle<FramebufferTraits>;
using VertexArrayHandle = Handle<VertexArrayTraits>;
using QueryHandle = Handle<QueryTraits>;
using ShaderHandle = Handle<ShaderTraits>;
using ProgramHandle = Handle<ProgramTraits>;

/// Names an object for debuggers and driver messages. Long labels are cut to what every driver
/// takes.
/// @param kind GL_BUFFER, GL_TEXTURE, GL_FRAMEBUFFER, ...
void label_object(GLenum kind, GLuint name, std::string_view label);

/// Bytes of buffers and textures that this process keeps on the device: what was asked for, without
/// the driver's own padding.
std::uint64_t device_bytes();

/// One owner's share of device_bytes(); gives it back when it dies.
class DeviceBytes {
public:
    DeviceBytes() = default;
    explicit DeviceBytes(std::uint64_t bytes);
    DeviceBytes(DeviceBytes&& other) noexcept : bytes_(std::exchange(other.bytes_, 0)) {}
    DeviceBytes& operator=(DeviceBytes&& other) noexcept {
        DeviceBytes taken(std::move(other));
        std::swap(bytes_, taken.bytes_);
        return *this;
    }
    DeviceBytes(const DeviceBytes&) = delete;
    DeviceBytes& operator=(const DeviceBytes&) = delete;
    ~DeviceBytes();

    [[nodiscard]] std::uint64_t count() const { return bytes_; }

private:
    std::uint64_t bytes_ = 0;
};

} // namespace gpu
