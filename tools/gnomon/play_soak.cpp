#include "engine/gpu/handle.hpp"
#include "engine/gpu/object_count.hpp"
#include "engine/scene/components.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tools/gnomon/play.hpp"
#include "tools/gnomon/play_visitor.hpp"

namespace gnomon {

namespace {

constexpr double kStep = 1.0 / 15.0;           // s
constexpr double kLook = 60.0;                 // s at either end, or half of a shorter soak
constexpr std::int64_t kMemoryBound = 8 << 20; // bytes: what the allocator may keep for itself
constexpr std::int64_t kObjectBound = 32;      // of the techniques that come and go with the view
constexpr double kBytesPerMib = 1 << 20;

/// What must not grow.
struct Holdings {
    std::int64_t heap_bytes = 0; ///< allocated and not freed
    std::int64_t resident_bytes = 0;
    std::int64_t device_bytes = 0;
    std::int64_t objects = 0; ///< of OpenGL
    std::int64_t files = 0;   ///< open ones
    std::int64_t entities = 0;

    [[nodiscard]] std::string text() const {
        return fmt::format(
            "{:.1f} MiB of heap, {:.1f} MiB resident, {:.1f} MiB on the device, {} OpenGL objects, "
            "{} "
            "open files, {} entities",
            static_cast<double>(heap_bytes) / kBytesPerMib,
            static_cast<double>(resident_bytes) / kBytesPerMib,
            static_cast<double>(device_bytes) / kBytesPerMib,
            objects,
            files,
            entities);
    }
};

#ifdef __SANITIZE_ADDRESS__
/// Source: sanitizer/allocator_interface.h, which GCC 12 does not bring.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();

std::int64_t heap_bytes() {
    return static_cast<std::int64_t>(__sanitizer_get_current_allocated_bytes());
}
// Freed memory stays resident in quarantine, hundreds of MiB of it.
constexpr bool kResidentTells = false;
#else
/// Source: mallinfo(3), arenas and mappings.
std::int64_t heap_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
}
constexpr bool kResidentTells = true;
#endif

/// Pages of this process that are in memory. Source: proc(5), /proc/[pid]/statm.
std::int64_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::int64_t total = 0;
    std::int64_t resident = 0;
    file >> total >> resident;
    return resident * sysconf(_SC_PAGESIZE);
}

/// Source: proc(5), /proc/[pid]/fd.
std::int64_t open_files() {
    const std::filesystem::directory_iterator files("/proc/self/fd");
    return std::distance(begin(files), end(files));
}

Holdings holdings(const Level& level) {
    return {
        heap_bytes(),
        resident_bytes(),
        static_cast<std::int64_t>(gpu::device_bytes()),
        gpu::count_objects(),
        open_files(),
        static_cast<std::int64_t>(level.world.registry.count<scene::Transform>())};
}

/// The more of each.
Holdings most(const Holdings& a, const Holdings& b) {
    return {
        std::max(a.heap_bytes, b.heap_bytes),
        std::max(a.resident_bytes, b.resident_bytes),
        std::max(a.device_bytes, b.device_bytes),
        std::max(a.objects, b.objects),
        std::max(a.files, b.files),
        std::max(a.entities, b.entities)};
}

bool more(const Holdings& late, const Holdings& early) {
    return late.heap_bytes - early.heap_bytes > kMemoryBound
           || (kResidentTells && late.resident_bytes - early.resident_bytes > kMemoryBound)
           || late.device_bytes - early.device_bytes > kMemoryBound
           || late.objects - early.objects > kObjectBound || late.files > early.files
           || late.entities > early.entities;
}

} // namespace

engine::Result<bool>
soak(Studio& studio, Level& level, const PlayOptions& options, const glm::ivec2& size) {
    constexpr double kTellEvery = 10.0; // s
    constexpr double kFlightSeconds = 30.0;
    Visitor visitor(level, size, kFlightSeconds);
    const double look = std::min(kLook, options.soak_seconds / 2.0);
    Holdings early;
    Holdings late;
    double told = 0.0;
    int frames = 0;
    for (double time = 0.0; time < options.soak_seconds; time = ++frames * kStep) {
        advance(level, static_cast<float>(kStep));
        if (auto drawn = studio.draw(level, visitor.advance(kStep)); !drawn) return drawn.error();
        const Holdings now = holdings(level);
        if (time <= look) early = most(early, now);
        if (time >= options.soak_seconds - look) late = most(late, now);
        if (time < told) continue;
        told += kTellEvery;
        fmt::print("{:5.0f} s: {}\n", time, now.text());
        std::fflush(stdout);
    }
    fmt::print(
        "the most of the first {0:.0f} s: {1}\nthe most of the last {0:.0f} s: {2}\n{3} frames, "
        "{4} "
        "rounds, {5} points missed\n",
        look,
        early.text(),
        late.text(),
        frames,
        visitor.rounds(),
        visitor.missed());
    return !more(late, early);
}

} // namespace gnomon
