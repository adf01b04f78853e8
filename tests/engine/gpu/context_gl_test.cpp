#include "engine/gpu/context.hpp"
#include "engine/gpu/pass.hpp"
#include "engine/gpu/pass_timer.hpp"
#include "engine/gpu/probe.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/window.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdlib>
#include <thread>

namespace gpu {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

class ContextGl : public test_support::GlTest {};
class PassTimersGl : public test_support::GlTest {};
class ProbeGl : public test_support::GlTest {};

TEST_F(ContextGl, SaysWhatItRunsOn) {
    const DeviceInfo& device = context().device();

    EXPECT_THAT(device.version, StartsWith("4."));
    EXPECT_NE(device.renderer, "");
    EXPECT_GE(device.max_texture_size, 16384);
    EXPECT_GE(device.max_color_attachments, 8);
}

TEST_F(ContextGl, SetsClipControlForReversedDepth) {
    GLint origin = 0;
    GLint range = 0;

    glGetIntegerv(GL_CLIP_ORIGIN, &origin);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &range);

    EXPECT_EQ(origin, static_cast<GLint>(GL_LOWER_LEFT));
    EXPECT_EQ(range, static_cast<GLint>(GL_ZERO_TO_ONE));
}

TEST(ContextDeathTest, AnErrorAbortsWhenErrorsAreFatal) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    if (test_support::shared_context() == nullptr) GTEST_SKIP() << "no OpenGL";

    EXPECT_DEATH(
        {
            const auto fatal = make_headless_context({.errors_fatal = true});
            glEnable(GL_TEXTURE_2D_ARRAY);
        },
        "OpenGL error");
}

TEST_F(ProbeGl, ThisDriverClampsDepthAndWrapsStencil) {
    const DriverProbe probe = probe_driver();

    EXPECT_TRUE(probe.clamps_depth);
    EXPECT_TRUE(probe.wraps_stencil);
}

/// One frame with three empty passes.
void run_frame(PassTimers& timers) {
    timers.begin_frame();
    for (const char* name : {"sun/cascaded_map", "lighting", "sun/cascaded_map"}) {
        timers.begin_pass(name);
        timers.end_pass();
    }
    timers.end_frame();
}

std::vector<std::string> names(const std::vector<PassTime>& times) {
    std::vector<std::string> found;
    for (const PassTime& time : times)
        found.push_back(time.name);
    return found;
}

TEST_F(PassTimersGl, FinishTimesPassesOnlyWhileProfiling) {
    PassTimers timers(TimerBackend::finish);

    run_frame(timers);
    EXPECT_THAT(timers.latest(), IsEmpty());

    timers.set_profiling(true);
    run_frame(timers);
    EXPECT_THAT(names(timers.latest()), ElementsAre("sun/cascaded_map", "lighting"));
    EXPECT_EQ(timers.latest_frame(), 2U);
}

TEST_F(PassTimersGl, TimestampsArriveFramesLater) {
    PassTimers timers(TimerBackend::timestamp);

    for (int i = 0; i < 8; ++i) {
        run_frame(timers);
        glFinish();
    }

    EXPECT_THAT(names(timers.latest()), ElementsAre("sun/cascaded_map", "lighting"));
    EXPECT_EQ(timers.latest_frame(), 7U);
}

TEST_F(PassTimersGl, AFrameWithManyPassesAfterOneWithFewIsReadWhole) {
    PassTimers timers(TimerBackend::timestamp);
    timers.begin_frame();
    timers.end_frame();
    for (int i = 0; i < 6; ++i) {
        run_frame(timers);
        glFinish();
    }

    EXPECT_THAT(timers.latest(), testing::SizeIs(2));
}

TEST_F(PassTimersGl, TheProbeDistrustsTimestampsOfARasteriser) {
    const TimerBackend backend = probe_timer_backend();

    if (!context().device().software) GTEST_SKIP() << "timestamps of hardware may be right";
    EXPECT_EQ(backend, TimerBackend::finish);
    EXPECT_EQ(name(backend), "finish");
}

TEST(WindowGl, ShowsWhatIsDrawn) {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no display";
    const auto window = make_window_context({.width = 64, .height = 48, .context = {}});
    if (!window) GTEST_SKIP() << engine::to_string(window.error());
    Frame frame(TimerBackend::finish);

    (*window)->poll();
    const Framebuffer target = (*window)->framebuffer();
    frame.begin();
    {
        const ScopedPass pass(
            frame, "window", target, {.color = glm::vec4(1.0F, 0.0F, 0.0F, 1.0F)});
    }
    frame.end();
    const engine::Image image = read_window(target);
    (*window)->swap();

    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 48);
    EXPECT_EQ(image.at(10, 10)[0], 255);
    EXPECT_EQ((*window)->context().error_count(), 0);
}

} // namespace
} // namespace gpu
