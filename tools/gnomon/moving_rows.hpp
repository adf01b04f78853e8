// Rows of sequences: something moves by a protocol, and truth is traced for every frame.

#pragma once

#include "tools/gnomon/still_rows.hpp"

namespace gnomon {

/// One row per technique, in their order.
/// @param protocol one of protocol_names(), not "still"
/// @param light index into the lights of the level
/// Errors: a shader or a file that fails, and those of `done`. A technique that cannot serve
/// becomes a row with a note.
engine::Result<void> measure_motion(
    Measurement& measurement,
    const scene::CameraView& start,
    std::size_t light,
    const std::string& protocol,
    std::span<const std::string> techniques,
    const RowSink& done);

} // namespace gnomon
