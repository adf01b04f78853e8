#include "engine/gpu/object_count.hpp"

#include <epoxy/gl.h>

namespace gpu {

namespace {

/// @param is_object whether a name means an object of the kind
template <class Predicate>
std::int64_t count(Predicate is_object) {
    constexpr int kUnusedInARow = 1000;
    std::int64_t found = 0;
    GLuint name = 1;
    for (int unused = 0; unused < kUnusedInARow; ++name) {
        const bool used = is_object(name);
        found += used ? 1 : 0;
        unused = used ? 0 : unused + 1;
    }
    return found;
}

} // namespace

// libepoxy's gl* are macros, so each is called by a function of its own.
std::int64_t count_objects() {
    return count([](GLuint name) { return glIsBuffer(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsTexture(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsSampler(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsFramebuffer(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsVertexArray(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsQuery(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsShader(name) == GL_TRUE; })
           + count([](GLuint name) { return glIsProgram(name) == GL_TRUE; });
}

} // namespace gpu
