#include "tools/gnomon/frame_times.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace gnomon {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRounds = 3;
constexpr int kProfiledFrames = 5;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
    CHECK(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) * 0.5;
}

using Draw = std::function<engine::Result<void>(bool)>;

/// One round of one kind: `warmup` frames that do not count, then `count` that do.
engine::Result<void>
time_round(const Draw& draw, bool with, int warmup, int count, std::vector<double>& frame_ms) {
    for (int i = 0; i < warmup; ++i)
        if (auto drawn = draw(with); !drawn) return drawn;
    for (int i = 0; i < count; ++i) {
        const auto start = Clock::now();
        if (auto drawn = draw(with); !drawn) return drawn;
        frame_ms.push_back(milliseconds_since(start));
    }
    return {};
}

/// Medians over some frames that do nothing but measure their passes.
engine::Result<std::vector<gpu::PassTime>> profile(Studio& studio, const Draw& draw) {
    gpu::PassTimers& timers = studio.renderer().frame().timers();
    timers.set_profiling(true);
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> by_name;
    for (int i = 0; i < kProfiledFrames; ++i) {
        if (auto drawn = draw(true); !drawn) return drawn.error();
        for (const gpu::PassTime& pass : timers.latest()) {
            if (!by_name.contains(pass.name)) order.push_back(pass.name);
            by_name[pass.name].push_back(pass.ms);
        }
    }
    timers.set_profiling(false);
    std::vector<gpu::PassTime> passes;
    for (const std::string& name : order)
        passes.push_back({name, median(by_name[name])});
    return passes;
}

} // namespace

FrameStatistics statistics(std::vector<double> frame_ms) {
    CHECK(!frame_ms.empty());
    std::sort(frame_ms.begin(), frame_ms.end());
    const auto last = static_cast<double>(frame_ms.size() - 1);
    return {
        median(frame_ms),
        frame_ms.front(),
        frame_ms[static_cast<std::size_t>(std::ceil(last * 0.99))]};
}

engine::Result<FrameTimes> time_frames(
    Studio& studio,
    const TimingOptions& options,
    const std::function<engine::Result<void>(bool)>& draw) {
    std::vector<double> with;
    std::vector<double> without;
    const int per_round = (options.frames + kRounds - 1) / kRounds;
    const auto start = Clock::now();
    for (int round = 0; round < kRounds; ++round) {
        const int count = std::min(per_round, options.frames - static_cast<int>(with.size()));
        if (count <= 0 || (round > 0 && milliseconds_since(start) > options.seconds * 1000.0))
            break;
        if (auto timed = time_round(draw, false, options.warmup, count, without); !timed)
            return timed.error();
        if (auto timed = time_round(draw, true, options.warmup, count, with); !timed)
            return timed.error();
    }
    FrameTimes times;
    times.frames = static_cast<int>(with.size());
    times.with = statistics(std::move(with));
    times.without = statistics(std::move(without));
    auto passes = profile(studio, draw);
    if (!passes) return passes.error();
    times.passes = *std::move(passes);
    return times;
}

} // namespace gnomon
