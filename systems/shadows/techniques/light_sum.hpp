// A light of a size as a sum of points: each adds what it would give and what of that is blocked,
// in floats, and the ratio of the two lowers the mask.
//
// What a point would give is the cosine between it and the surface, so points under a surface's
// horizon do not count there. Source: P. Heckbert and M. Herf, "Simulating Soft Shadows with
// Graphics Hardware", CMU-CS-97-104, 1997.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"

#include <span>
#include <string>

namespace shadows {

class LightSum {
public:
    /// Makes the sum as large as the picture.
    /// Errors: a shader that does not compile; the driver does not draw into the sum.
    engine::Result<void>
    prepare(gpu::ShaderLibrary& shaders, const std::string& label, const glm::ivec2& size);

    /// What programs add (blocked, given) to, from 0 on.
    [[nodiscard]] const gpu::Framebuffer& target() const { return target_; }

    /// Lowers the mask to what is not blocked. @pre a pass on the mask is open
    void compose(gpu::Frame& frame, std::span<const gpu::Rect> areas) const;

    [[nodiscard]] std::size_t gpu_bytes() const { return texture_.size_bytes(); }

private:
    gpu::Texture texture_; ///< rg32f: blocked, given
    gpu::Framebuffer target_;
    const gpu::Program* program_ = nullptr;
};

} // namespace shadows
