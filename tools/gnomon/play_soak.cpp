#include "engine/gpu/handle.hpp"
#include "engine/scene/components.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "tools/gnomon/play.hpp"
#include "tools/gnomon/play_visitor.hpp"

namespace gnomon {

namespace {

constexpr double kStep = 1.0 / 15.0;           // s
constexpr double kWarmUp = 60.0;               // s, or half of a shorter soak
constexpr std::int64_t kMemoryBound = 8 << 20; // bytes: what the allocator may keep for itself
constexpr double kBytesPerMib = 1 << 20;

/// What must not grow.
struct Holdings {
    std::int64_t resident_bytes = 0;
    std::int64_t device_bytes = 0;
    std::int64_t entities = 0;

    [[nodiscard]] std::string text() const {
        return fmt::format(
            "{:.1f} MiB resident, {:.1f} MiB on the device, {} entities",
            static_cast<double>(resident_bytes) / kBytesPerMib,
            static_cast<double>(device_bytes) / kBytesPerMib,
            entities);
    }
};

/// Pages of this process that are in memory. Source: proc(5), /proc/[pid]/statm.
std::int64_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::int64_t total = 0;
    std::int64_t resident = 0;
    file >> total >> resident;
    return resident * sysconf(_SC_PAGESIZE);
}

Holdings holdings(const Level& level) {
    return {
        resident_bytes(),
        static_cast<std::int64_t>(gpu::device_bytes()),
        static_cast<std::int64_t>(level.world.registry.count<scene::Transform>())};
}

} // namespace

engine::Result<bool>
soak(Studio& studio, Level& level, const PlayOptions& options, const glm::ivec2& size) {
    constexpr double kTellEvery = 10.0; // s
    constexpr double kFlightSeconds = 30.0;
    Visitor visitor(level, size, kFlightSeconds);
    const double warm_up = std::min(kWarmUp, options.soak_seconds / 2.0);
    const Holdings start = holdings(level);
    Holdings warm = start;
    double told = 0.0;
    int frames = 0;
    for (double time = 0.0; time < options.soak_seconds; time = ++frames * kStep) {
        if (time <= warm_up) warm = holdings(level);
        advance(level, static_cast<float>(kStep));
        if (auto drawn = studio.draw(level, visitor.advance(kStep)); !drawn) return drawn.error();
        if (time < told) continue;
        told += kTellEvery;
        fmt::print("{:5.0f} s: {}\n", time, holdings(level).text());
        std::fflush(stdout);
    }
    const Holdings end = holdings(level);
    fmt::print(
        "start:  {}\nwarm:   {} (after {:.0f} s)\nend:    {}\n{} frames, {} rounds, {} points "
        "missed\n",
        start.text(),
        warm.text(),
        warm_up,
        end.text(),
        frames,
        visitor.rounds(),
        visitor.missed());
    return end.resident_bytes - warm.resident_bytes <= kMemoryBound
           && end.device_bytes - warm.device_bytes <= kMemoryBound && end.entities == warm.entities;
}

} // namespace gnomon
