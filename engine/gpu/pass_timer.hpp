// How long each pass takes on the device, by one of two clocks.
//
// Timestamps are read frames later and cost nothing, where the driver tells the truth. A rasteriser
// that defers its work reports them wrong by orders of magnitude; there each pass is fenced by
// glFinish and timed by the CPU, which slows the frame down and so happens only while profiling.

#pragma once

#include "engine/gpu/handle.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gpu {

enum class TimerBackend : std::uint8_t { timestamp, finish };

/// "timestamp" or "finish".
std::string_view name(TimerBackend backend);

/// Times a heavy pass by both clocks: timestamp where they agree within 20 %, else finish.
/// Needs a current context. Cost: some tens of milliseconds, once.
TimerBackend probe_timer_backend();

struct PassTime {
    std::string name;
    double ms = 0.0;
};

class PassTimers {
public:
    explicit PassTimers(TimerBackend backend) : backend_(backend) {}

    /// While profiling, and only then, the finish back end waits for the device round each pass. A
    /// frame timed as a whole must not profile. Timestamps are taken in either case.
    void set_profiling(bool on) { profiling_ = on; }

    void begin_frame();
    void end_frame();
    void begin_pass(std::string_view name);
    void end_pass();

    [[nodiscard]] TimerBackend backend() const { return backend_; }

    /// The latest frame whose times have arrived, in the order of its passes; passes of one name
    /// are added up. Empty before the first, and with the finish back end when nothing was
    /// profiled.
    [[nodiscard]] const std::vector<PassTime>& latest() const { return latest_; }

    /// The frame that latest() belongs to, counted from 1; 0 when there is none.
    [[nodiscard]] std::uint64_t latest_frame() const { return latest_frame_; }

private:
    using CpuClock = std::chrono::steady_clock;

    /// The passes of one frame in flight: names, and two queries each.
    struct FrameQueries {
        std::vector<std::string> names;
        std::vector<QueryHandle> queries; ///< kept and reused; at least two per name
        std::uint64_t frame = 0;          ///< 0 when read or never used
    };
    static constexpr std::size_t kFramesInFlight = 4;

    void take_timestamp();
    void read_if_ready(FrameQueries& frame);

    TimerBackend backend_;
    bool profiling_ = false;
    bool timing_ = false; ///< whether the current frame is timed
    std::uint64_t frame_ = 0;
    std::array<FrameQueries, kFramesInFlight> ring_;
    std::size_t query_count_ = 0; ///< used so far in the current frame
    CpuClock::time_point pass_start_;
    std::string measured_name_;
    std::vector<PassTime> measured_; ///< by the finish back end, in the current frame
    std::vector<PassTime> latest_;
    std::uint64_t latest_frame_ = 0;
};

} // namespace gpu
