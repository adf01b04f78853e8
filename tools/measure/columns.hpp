// The one list of what a measurement consists of: name, unit, meaning and place of every figure.
// The terminal table, CSV and JSON are written from it.

#pragma once

#include <span>
#include <string_view>

#include "tools/measure/figures.hpp"
#include "tools/measure/motion.hpp"

namespace measure {

/// How a figure of a group T is read and written.
template <class T>
struct Access {
    Figure (*get)(const T&);
    void (*set)(T&, const Figure&) = nullptr; ///< null for what follows from other figures
};

/// One figure of a group T. Names and order are stable: files written today can be read next year.
template <class T>
struct FigureColumn {
    std::string_view name; ///< CSV header and JSON key
    std::string_view unit; ///< empty for a count of nothing or a ratio
    std::string_view text; ///< what it is
    int decimals;          ///< in the terminal table; kNotInTable to leave it out there
    Access<T> access;
};

inline constexpr int kNotInTable = -1;

/// Time of one frame, the median and worst of its repeats, against the same frame without shadows.
struct Timing {
    double median_ms = 0.0;
    double p99_ms = 0.0;
    double without_median_ms = 0.0;
};

/// What one frame's shadows asked of the device: counts that do not jitter as times do.
struct Counters {
    double draws = 0.0;
    double triangles = 0.0;
    double map_texels = 0.0;
    double mask_fragments = 0.0;
    double stencil_fragments = 0.0;
    double taps = 0.0;
    double gpu_bytes = 0.0;
};

template <class T>
std::span<const FigureColumn<T>> columns_of();

template <>
std::span<const FigureColumn<Figures>> columns_of();
template <>
std::span<const FigureColumn<MotionFigures>> columns_of();
template <>
std::span<const FigureColumn<Timing>> columns_of();
template <>
std::span<const FigureColumn<Counters>> columns_of();

} // namespace measure
