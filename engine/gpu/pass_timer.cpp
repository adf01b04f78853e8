#include "engine/gpu/pass_timer.hpp"

#include "engine/core/check.hpp"

#include <algorithm>

namespace gpu {

namespace {

double milliseconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

/// Adds to the row of that name, or makes one at the end.
void add_time(std::vector<PassTime>& times, const std::string& name, double ms) {
    const auto row = std::find_if(
        times.begin(), times.end(), [&name](const PassTime& time) { return time.name == name; });
    if (row == times.end()) {
        times.push_back({name, ms});
    } else {
        row->ms += ms;
    }
}

} // namespace

std::string_view name(TimerBackend backend) {
    return backend == TimerBackend::timestamp ? "timestamp" : "finish";
}

void PassTimers::begin_frame() {
    ++frame_;
    if (backend_ == TimerBackend::finish) {
        timing_ = profiling_;
        measured_.clear();
        return;
    }
    timing_ = true;
    // Oldest first, so that latest() ends at the newest that has arrived.
    for (std::size_t i = 0; i < kFramesInFlight; ++i) {
        read_if_ready(ring_[(frame_ + i) % kFramesInFlight]);
    }
    FrameQueries& current = ring_[frame_ % kFramesInFlight];
    current.names.clear();
    current.frame = 0;
    query_count_ = 0;
}

void PassTimers::end_frame() {
    if (!timing_) return;
    timing_ = false;
    if (backend_ == TimerBackend::timestamp) {
        ring_[frame_ % kFramesInFlight].frame = frame_;
        return;
    }
    latest_ = measured_;
    latest_frame_ = frame_;
}

void PassTimers::begin_pass(std::string_view name) {
    if (!timing_) return;
    if (backend_ == TimerBackend::finish) {
        measured_name_ = name;
        glFinish();
        pass_start_ = CpuClock::now();
        return;
    }
    ring_[frame_ % kFramesInFlight].names.emplace_back(name);
    take_timestamp();
}

void PassTimers::end_pass() {
    if (!timing_) return;
    if (backend_ == TimerBackend::finish) {
        glFinish();
        add_time(measured_, measured_name_, milliseconds(CpuClock::now() - pass_start_));
        return;
    }
    take_timestamp();
}

void PassTimers::take_timestamp() {
    std::vector<QueryHandle>& queries = ring_[frame_ % kFramesInFlight].queries;
    if (query_count_ == queries.size()) {
        GLuint query = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &query);
        queries.emplace_back(query);
    }
    glQueryCounter(queries[query_count_].name(), GL_TIMESTAMP);
    ++query_count_;
}

void PassTimers::read_if_ready(FrameQueries& frame) {
    if (frame.frame == 0) return;
    const std::size_t count = frame.names.size() * 2;
    CHECK_LE(count, frame.queries.size());
    if (count > 0) {
        GLint ready = 0;
        glGetQueryObjectiv(frame.queries[count - 1].name(), GL_QUERY_RESULT_AVAILABLE, &ready);
        if (ready == 0) return;
    }
    latest_.clear();
    for (std::size_t i = 0; i < frame.names.size(); ++i) {
        GLuint64 start = 0;
        GLuint64 end = 0;
        glGetQueryObjectui64v(frame.queries[2 * i].name(), GL_QUERY_RESULT, &start);
        glGetQueryObjectui64v(frame.queries[2 * i + 1].name(), GL_QUERY_RESULT, &end);
        constexpr double kMsPerNanosecond = 1e-6;
        add_time(latest_, frame.names[i], static_cast<double>(end - start) * kMsPerNanosecond);
    }
    latest_frame_ = frame.frame;
    frame.frame = 0;
}

} // namespace gpu
