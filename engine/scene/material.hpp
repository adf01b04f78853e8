// Materials and pictures: only what shadows and diffuse light need.

#pragma once

#include "engine/core/image.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

namespace scene {

inline constexpr std::uint32_t kNoTexture = 0xFFFFFFFFU;

enum class Wrap : std::uint8_t { repeat, mirror, clamp };

/// A picture with the way it is sampled. RGBA, sRGB-encoded colour, linear alpha.
struct Texture {
    std::string name;
    engine::Image image; ///< 4 channels
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool nearest = false; ///< no filtering, as the file asked
};

struct Material {
    std::string name;
    glm::vec4 base_color = {1.0F, 1.0F, 1.0F, 1.0F}; ///< linear
    std::uint32_t texture = kNoTexture;              ///< index into Assets::textures
    bool alpha_masked =
        false; ///< pixels with alpha < alpha_cutoff are holes, in pictures, shadows and truth alike
    float alpha_cutoff = 0.5F;
    bool double_sided =
        false; ///< drawn from both sides; shadows are cast by both sides in any case
};

} // namespace scene
