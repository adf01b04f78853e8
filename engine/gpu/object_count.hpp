// How many OpenGL objects there are, asked of the driver: what nobody owns is counted too.

#pragma once

#include <cstdint>

namespace gpu {

/// Buffers, textures, samplers, framebuffers, vertex arrays, queries, shaders and programs of the
/// current context. Names are tried from 1 on until a thousand in a row mean nothing, as drivers
/// give out low ones first.
/// Cost: some thousand calls; for tests.
std::int64_t count_objects();

} // namespace gpu
