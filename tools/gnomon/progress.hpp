// How far a long work is, and how long it will take, for someone who waits.

#pragma once

#include <chrono>
#include <string>

namespace gnomon {

/// "TEXT, 37 %, 2 min 10 s left".
/// @param done, total units of work; no time is promised before the first
/// @param seconds since the beginning
std::string progress_line(const std::string& text, double done, double total, double seconds);

/// Counts units of work and tells on standard error: in one line that is written again and again on
/// a terminal, else in a line each.
class Progress {
public:
    /// @param parts how many calls of begin_part() are to come
    explicit Progress(int parts = 1);
    /// Leaves an empty line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A part of the work begins. Parts that are still to come are taken to be as long as those
    /// that are known, on average.
    void begin_part(double units);
    /// So much of the work is done.
    void add(double units) { done_ += units; }
    /// What is being done now.
    void tell(const std::string& text) const;

    [[nodiscard]] double done() const { return done_; }
    [[nodiscard]] double total() const;

private:
    std::chrono::steady_clock::time_point start_;
    bool terminal_;
    int parts_;
    int begun_ = 0;
    double known_ = 0.0;
    double done_ = 0.0;
};

} // namespace gnomon
