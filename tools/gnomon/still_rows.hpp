// Rows of pictures in which nothing moves: every figure of a still, and 16 frames that must not
// differ.

#pragma once

#include <functional>
#include <span>

#include "tools/gnomon/measurement.hpp"

namespace gnomon {

/// Takes rows as they are finished.
using RowSink = std::function<engine::Result<void>(measure::Row row)>;

/// One row per technique, in their order; the truth is traced once.
/// @param light index into the lights of the level
/// Errors: a shader or a file that fails, and those of `done`. A technique that cannot serve
/// becomes a row with a note.
engine::Result<void> measure_stills(
    Measurement& measurement,
    const scene::CameraView& camera,
    std::size_t light,
    std::span<const std::string> techniques,
    const RowSink& done);

} // namespace gnomon
