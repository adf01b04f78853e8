#include "tests/support/gl_fixture.hpp"

#include <fmt/format.h>

namespace test_support {

namespace {

struct SharedContext {
    std::unique_ptr<gpu::Context> context;
    std::string failure;

    SharedContext() {
        engine::Result<std::unique_ptr<gpu::Context>> made = gpu::make_headless_context();
        if (made) {
            context = *std::move(made);
        } else {
            failure = engine::to_string(made.error());
        }
    }
};

SharedContext& shared() {
    static SharedContext one;
    return one;
}

} // namespace

gpu::Context* shared_context() {
    return shared().context.get();
}

void GlTest::SetUp() {
    if (shared_context() == nullptr) GTEST_SKIP() << shared().failure;
    context().make_current();
    errors_before_ = context().error_count();
}

void GlTest::TearDown() {
    if (shared_context() == nullptr) return;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(context().error_count(), errors_before_)
        << "the first kept message: "
        << (context().messages().empty() ? "none" : context().messages().front().text);
}

} // namespace test_support
