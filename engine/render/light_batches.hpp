// Which lights share a lighting pass, which share a layer of masks, and which can reach which part
// of the screen. Pure CPU, plain values.

#pragma once

#include "engine/gpu/texture.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace render {

/// The part of the picture that a light can reach, origin bottom left; empty when it reaches
/// nothing in view.
gpu::Rect screen_rect(const scene::CameraView& camera, const scene::PlacedLight& light);

/// One light of a batch.
struct BatchLight {
    std::uint32_t light = 0; ///< index into the frame's lights
    gpu::Rect area;
    std::optional<int> layer; ///< of its mask; none: unshadowed
};

/// Lights that one lighting pass adds up, with at most MAX_MASK_LAYERS masks.
struct LightBatch {
    std::vector<BatchLight> lights;
    int layer_count = 0;
};

/// Lights with empty areas are left out, directional ones come first in each batch. Masks whose
/// areas do not overlap share a layer. Always at least one batch.
/// @param areas one per light
/// @param masked one per light: it needs a mask
std::vector<LightBatch> batch_lights(
    std::span<const scene::PlacedLight> lights,
    std::span<const gpu::Rect> areas,
    const std::vector<bool>& masked);

/// A rectangle of the screen and the lights of a batch that can reach it. As lighting.vert reads
/// it.
struct LightTile {
    glm::uvec4 rectangle; ///< left, bottom, right, top, pixels
    std::uint32_t bits;   ///< bit i: LightBatch::lights[i]
};

/// Tiles cover the picture exactly; neighbours with the same lights are one.
std::vector<LightTile> light_tiles(const LightBatch& batch, int width, int height);

} // namespace render
