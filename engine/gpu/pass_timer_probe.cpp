// Chooses the pass timers' clock by timing a heavy pass with both.

#include "engine/gpu/pass.hpp"
#include "engine/gpu/pass_timer.hpp"
#include "engine/gpu/shader_library.hpp"

#include <array>
#include <chrono>
#include <cmath>

namespace gpu {

namespace {

struct ProbedTimes {
    double wall_ms = 0.0;
    double timestamp_ms = 0.0;
};

/// A pass whose weight can be chosen, over a target of many tiles: a rasteriser that works tile by
/// tile (llvmpipe: 64 x 64) stamps the time of the last tile alone, which is near the truth on a
/// small target.
class HeavyPass {
public:
    HeavyPass()
        : texture_("timer probe", {.format = Format::r32f, .width = kSide, .height = kSide}),
          target_(Framebuffer::make("timer probe", {.colors = {{.texture = &texture_}}})),
          program_(library_.graphics("gpu/fullscreen.vert", "gpu/timer_probe.frag")) {
        std::array<GLuint, 2> names = {};
        glCreateQueries(GL_TIMESTAMP, 2, names.data());
        start_ = QueryHandle(names[0]);
        end_ = QueryHandle(names[1]);
    }

    [[nodiscard]] bool usable() const { return target_ && program_; }

    ProbedTimes time(int iterations) {
        using Clock = std::chrono::steady_clock;
        const Program& program = **program_;
        program.set("iterations", iterations);
        frame_.begin();
        glFinish();
        const Clock::time_point before = Clock::now();
        {
            const ScopedPass pass(frame_, "timer probe", *target_);
            glQueryCounter(start_.name(), GL_TIMESTAMP);
            frame_.state(kScreenState);
            frame_.draw_fullscreen(program);
            glQueryCounter(end_.name(), GL_TIMESTAMP);
        }
        glFinish();
        const Clock::time_point after = Clock::now();
        frame_.end();

        GLuint64 start = 0;
        GLuint64 end = 0;
        glGetQueryObjectui64v(start_.name(), GL_QUERY_RESULT, &start);
        glGetQueryObjectui64v(end_.name(), GL_QUERY_RESULT, &end);
        constexpr double kMsPerNanosecond = 1e-6;
        return {
            std::chrono::duration<double, std::milli>(after - before).count(),
            static_cast<double>(end - start) * kMsPerNanosecond};
    }

private:
    static constexpr int kSide = 512;

    ShaderLibrary library_{{}};
    Texture texture_;
    engine::Result<Framebuffer> target_;
    engine::Result<const Program*> program_;
    QueryHandle start_;
    QueryHandle end_;
    Frame frame_{TimerBackend::finish};
};

bool agree(const ProbedTimes& times) {
    constexpr double kTolerance = 0.2;
    return std::abs(times.timestamp_ms - times.wall_ms) <= kTolerance * times.wall_ms;
}

} // namespace

TimerBackend probe_timer_backend() {
    HeavyPass heavy;
    if (!heavy.usable()) return TimerBackend::finish;
    heavy.time(1); // compiles the pipeline

    // Heavy enough that the cost of submitting it does not count.
    constexpr double kHeavyMs = 5.0;
    constexpr int kMostIterations = 1 << 20;
    int iterations = 16;
    while (iterations < kMostIterations && heavy.time(iterations).wall_ms < kHeavyMs) {
        iterations *= 4;
    }
    // Three times, as another process may disturb one.
    int agreed = 0;
    for (int i = 0; i < 3; ++i)
        agreed += agree(heavy.time(iterations)) ? 1 : 0;
    return agreed >= 2 ? TimerBackend::timestamp : TimerBackend::finish;
}

} // namespace gpu
