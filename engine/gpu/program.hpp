// A linked program and its uniforms, which are set by name.

#pragma once

#include "engine/gpu/handle.hpp"

#include <glm/glm.hpp>

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace gpu {

/// Made and reloaded by ShaderLibrary. Set every uniform that a draw needs before the draw: after a
/// reload they all start from zero.
///
/// A uniform that the driver found unused and removed is ignored; a name that appears nowhere in
/// the source is a programmer's slip and fails a CHECK. "lights[2].position" is named as in GLSL.
class Program {
public:
    Program() = default;

    /// @param identifiers every identifier in the sources that the program was compiled from
    Program(ProgramHandle handle, std::set<std::string, std::less<>> identifiers)
        : handle_(std::move(handle)),
          identifiers_(std::move(identifiers)) {}

    void set(std::string_view name, bool value) const;
    void set(std::string_view name, int value) const; ///< an int, or the texture unit of a sampler
    void set(std::string_view name, unsigned value) const;
    void set(std::string_view name, float value) const;
    void set(std::string_view name, const glm::vec2& value) const;
    void set(std::string_view name, const glm::vec3& value) const;
    void set(std::string_view name, const glm::vec4& value) const;
    void set(std::string_view name, const glm::ivec2& value) const;
    void set(std::string_view name, const glm::ivec3& value) const;
    void set(std::string_view name, const glm::ivec4& value) const;
    void set(std::string_view name, const glm::uvec2& value) const;
    void set(std::string_view name, const glm::uvec4& value) const;
    void set(std::string_view name, const glm::mat3& value) const;
    void set(std::string_view name, const glm::mat4& value) const;
    void set(std::string_view name, std::span<const float> values) const;
    void set(std::string_view name, std::span<const glm::vec2> values) const;
    void set(std::string_view name, std::span<const glm::vec3> values) const;
    void set(std::string_view name, std::span<const glm::vec4> values) const;
    void set(std::string_view name, std::span<const glm::mat4> values) const;

    [[nodiscard]] GLuint name() const { return handle_.name(); }

private:
    /// -1 for a uniform that the driver removed.
    [[nodiscard]] GLint location(std::string_view name) const;

    ProgramHandle handle_;
    std::set<std::string, std::less<>> identifiers_;
    mutable std::map<std::string, GLint, std::less<>> locations_;
};

} // namespace gpu
