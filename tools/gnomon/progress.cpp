#include "tools/gnomon/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gnomon {

namespace {

/// Two units at most: 3 h 20 min, 2 min 10 s, 5 s.
std::string duration(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole >= 3600) return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
    if (whole >= 60) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} s", whole);
}

} // namespace

std::string progress_line(const std::string& text, double done, double total, double seconds) {
    if (done <= 0.0 || total <= 0.0) return text;
    const double left = std::max(0.0, total - done);
    return fmt::format(
        "{}, {:.0f} %, {} left",
        text,
        std::floor(100.0 * std::min(1.0, done / total)),
        duration(seconds / done * left));
}

Progress::Progress(int parts)
    : start_(std::chrono::steady_clock::now()),
      terminal_(isatty(STDERR_FILENO) != 0),
      parts_(parts) {}

Progress::~Progress() {
    if (terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::begin_part(double units) {
    ++begun_;
    known_ += units;
}

double Progress::total() const {
    const int to_come = std::max(0, parts_ - begun_);
    return begun_ == 0 ? known_ : known_ * (1.0 + static_cast<double>(to_come) / begun_);
}

void Progress::tell(const std::string& text) const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const std::string line = progress_line(text, done_, total(), seconds);
    if (terminal_)
        fmt::print(stderr, "\r\x1b[K{}", line);
    else
        fmt::print(stderr, "{}\n", line);
    std::fflush(stderr);
}

} // namespace gnomon
