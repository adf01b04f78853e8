// Where what is blocked of a light's points adds up: a colour, and a stencil beside it that keeps a
// point from counting twice.

#pragma once

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/texture.hpp"

#include <string>

namespace shadows {

struct SumTarget {
    gpu::Texture texture;
    gpu::Texture stencil;
    gpu::Framebuffer framebuffer;

    /// Makes it anew unless it has that size and format.
    /// Errors: the driver does not draw into it.
    engine::Result<void> prepare(const std::string& label, const gpu::TextureDescription& sum);

    [[nodiscard]] std::size_t gpu_bytes() const {
        return texture.size_bytes() + stencil.size_bytes();
    }
};

} // namespace shadows
