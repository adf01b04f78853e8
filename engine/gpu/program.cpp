#include "engine/gpu/program.hpp"

#include "engine/core/check.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace gpu {

GLint Program::location(std::string_view name) const {
    const auto known = locations_.find(name);
    if (known != locations_.end()) return known->second;

    const std::string_view base = name.substr(0, name.find_first_of(".["));
    if (identifiers_.find(base) == identifiers_.end()) {
        engine::check_failed(
            __FILE__,
            __LINE__,
            "uniform is in the source",
            fmt::format("no '{}' in this program's shaders", base));
    }
    const std::string text(name);
    const GLint found = glGetUniformLocation(this->name(), text.c_str());
    locations_.emplace(text, found);
    return found;
}

void Program::set(std::string_view name, bool value) const {
    glProgramUniform1i(this->name(), location(name), value ? 1 : 0);
}
void Program::set(std::string_view name, int value) const {
    glProgramUniform1i(this->name(), location(name), value);
}
void Program::set(std::string_view name, unsigned value) const {
    glProgramUniform1ui(this->name(), location(name), value);
}
void Program::set(std::string_view name, float value) const {
    glProgramUniform1f(this->name(), location(name), value);
}
void Program::set(std::string_view name, const glm::vec2& value) const {
    glProgramUniform2fv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec3& value) const {
    glProgramUniform3fv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec4& value) const {
    glProgramUniform4fv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::ivec2& value) const {
    glProgramUniform2iv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::ivec3& value) const {
    glProgramUniform3iv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::ivec4& value) const {
    glProgramUniform4iv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::uvec2& value) const {
    glProgramUniform2uiv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::uvec4& value) const {
    glProgramUniform4uiv(this->name(), location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat3& value) const {
    glProgramUniformMatrix3fv(this->name(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(this->name(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

namespace {

template <class T>
GLsizei count_of(std::span<const T> values) {
    return static_cast<GLsizei>(values.size());
}

/// The first scalar of an array of vectors or matrices.
template <class T>
const float* scalars(std::span<const T> values) {
    return values.empty() ? nullptr : glm::value_ptr(values.front());
}

} // namespace

void Program::set(std::string_view name, std::span<const float> values) const {
    glProgramUniform1fv(this->name(), location(name), count_of(values), values.data());
}
void Program::set(std::string_view name, std::span<const glm::vec2> values) const {
    glProgramUniform2fv(this->name(), location(name), count_of(values), scalars(values));
}
void Program::set(std::string_view name, std::span<const glm::vec3> values) const {
    glProgramUniform3fv(this->name(), location(name), count_of(values), scalars(values));
}
void Program::set(std::string_view name, std::span<const glm::vec4> values) const {
    glProgramUniform4fv(this->name(), location(name), count_of(values), scalars(values));
}
void Program::set(std::string_view name, std::span<const glm::mat4> values) const {
    glProgramUniformMatrix4fv(
        this->name(), location(name), count_of(values), GL_FALSE, scalars(values));
}

} // namespace gpu
