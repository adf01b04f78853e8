// Tests that need OpenGL derive from GlTest: one headless context per process, made at first use.

#pragma once

#include "engine/gpu/context.hpp"
#include "engine/gpu/frame.hpp"
#include "engine/gpu/shader_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace test_support {

/// The process's context, or null where there is no OpenGL.
gpu::Context* shared_context();

/// Skips without OpenGL, and fails a test that leaves an OpenGL error or message behind. With
/// GNOMON_GL_ERRORS=fatal the guilty call aborts on the spot.
class GlTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    [[nodiscard]] static gpu::Context& context() { return *shared_context(); }

private:
    int errors_before_ = 0;
};

} // namespace test_support
