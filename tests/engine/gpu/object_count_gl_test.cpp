#include "engine/gpu/object_count.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>

namespace gpu {
namespace {

using ObjectCount = test_support::GlTest;

TEST_F(ObjectCount, KnowsObjectsOfEveryKindUntilTheyAreDeleted) {
    const std::int64_t before = count_objects();
    std::array<GLuint, 6> names = {};
    glCreateBuffers(1, &names[0]);
    glCreateTextures(GL_TEXTURE_2D, 1, &names[1]);
    glCreateSamplers(1, &names[2]);
    glCreateFramebuffers(1, &names[3]);
    glCreateVertexArrays(1, &names[4]);
    glCreateQueries(GL_TIME_ELAPSED, 1, &names[5]);
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    const GLuint program = glCreateProgram();

    EXPECT_EQ(count_objects(), before + 8);

    glDeleteBuffers(1, &names[0]);
    glDeleteTextures(1, &names[1]);
    glDeleteSamplers(1, &names[2]);
    glDeleteFramebuffers(1, &names[3]);
    glDeleteVertexArrays(1, &names[4]);
    glDeleteQueries(1, &names[5]);
    glDeleteShader(shader);
    glDeleteProgram(program);
    EXPECT_EQ(count_objects(), before);
}

} // namespace
} // namespace gpu
