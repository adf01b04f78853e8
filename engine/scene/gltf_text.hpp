// The text of a glTF file before the parser sees it: the container's lengths, how deep the JSON
// nests, and numbers that the parser would silently turn into other numbers (negative, fractional
// or huge indices).

#pragma once

#include "engine/core/result.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace scene {

/// Whether the bytes begin as a binary glTF file does.
bool is_binary_gltf(std::span<const std::uint8_t> bytes);

/// The JSON of a .gltf or .glb file.
/// Errors: a binary container whose lengths reach past its end or whose chunks are not JSON and
/// BIN.
engine::Result<std::string_view> gltf_text(std::span<const std::uint8_t> bytes);

/// Errors: not JSON, nested deeper than kMaxDepth, or an index, offset, length or count that is not
/// a whole number in [0, 2^31); the sentence names the property.
engine::Result<void> check_gltf_text(std::string_view json);

} // namespace scene
