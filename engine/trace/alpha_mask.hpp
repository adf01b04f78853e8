// The holes of cut-out materials, as rays meet them: the same test that the rasteriser makes per
// pixel, at one exact texture coordinate.

#pragma once

#include "engine/scene/material.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace trace {

/// The alpha channel of a material's texture with its factor and cutoff; owns its copy.
class AlphaMask {
public:
    /// @pre material.alpha_masked
    AlphaMask(const scene::Material& material, std::span<const scene::Texture> textures);

    /// Bilinear unless the texture is `nearest`, of the finest level; the wrap mode decides past
    /// the edges.
    [[nodiscard]] bool hole_at(const glm::dvec2& uv) const;

private:
    [[nodiscard]] double texel(std::int64_t x, std::int64_t y) const;
    [[nodiscard]] double sample(const glm::dvec2& uv) const;

    double factor_ = 1.0;
    double cutoff_ = 0.5;
    int width_ = 0; ///< 0: no texture, alpha is the factor everywhere
    int height_ = 0;
    scene::Wrap wrap_u_ = scene::Wrap::repeat;
    scene::Wrap wrap_v_ = scene::Wrap::repeat;
    bool nearest_ = false;
    std::vector<std::uint8_t> alpha_; ///< width * height, top row first
};

} // namespace trace
