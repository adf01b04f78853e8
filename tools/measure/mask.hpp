// What is compared: the visibility of one light as a technique drew it and as it truly is, pixel by
// pixel.

#pragma once

#include "engine/core/image.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace measure {

/// Visibility of one light over a picture: 1 lit, 0 dark. Top row first.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<float> visibility;

    Mask() = default;
    Mask(int width_px, int height_px, float value = 1.0F)
        : width(width_px),
          height(height_px),
          visibility(
              static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), value) {}

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
               + static_cast<std::size_t>(x);
    }
    [[nodiscard]] float at(int x, int y) const { return visibility[index(x, y)]; }
    [[nodiscard]] float& at(int x, int y) { return visibility[index(x, y)]; }
    [[nodiscard]] std::size_t pixel_count() const { return visibility.size(); }
};

/// The side of the edge that a visibility stands on; half lit counts as lit.
inline bool lit(float visibility) {
    return visibility >= 0.5F;
}

/// What a pixel may be used for. Only `valid` pixels enter the figures of a mask.
enum class PixelKind : std::uint8_t {
    valid,     ///< both renderers see the same surface, turned to the light, and the truth is sure
    undecided, ///< the same surface, but the truth changes with its own offsets
    grazing,   ///< turned to the light by less than one degree
    facing_away, ///< turned away: shading makes it dark whatever its mask says
    mismatch,    ///< the two renderers see different surfaces: a silhouette of the geometry
    empty,       ///< no surface in either picture
};

/// What is known of one pixel before it is classified.
struct PixelEvidence {
    std::uint32_t measured_entity = 0; ///< 0: no surface
    std::uint32_t truth_entity = 0;
    float measured_depth = 0.0F; ///< view depth, metres
    float truth_depth = 0.0F;
    /// Towards the light: the smaller of the geometric normal's and of the one that shading takes.
    /// Smooth shading leaves facets along its terminator dark although they face the light.
    float n_dot_l = 1.0F;
    bool undecided = false;
};

inline constexpr float kDepthTolerance = 1e-3F;       ///< relative
inline constexpr float kGrazingCosine = 0.017452406F; ///< cos 89 degrees

PixelKind classify(const PixelEvidence& evidence);

/// One light in one frame, measured and true. All vectors hold one value per pixel, top row first.
struct Comparison {
    Mask measured;
    Mask truth;
    std::vector<PixelKind> kind;
    bool soft = false; ///< the light has an area, so the truth holds values between 0 and 1

    /// How far from a true edge, in px, the technique's own resolution may be wrong: empty when it
    /// has none of its own (volumes, projected shadows), one value for all pixels, or one per
    /// pixel. See resolution_band_px().
    std::vector<float> resolution_band_px;

    /// 1 for pixels in whose band a true edge lies although no two pixels' truths show it: that of
    /// a shadow thinner than a pixel, or one that ends where the next pixel shows something else.
    /// Empty: none.
    std::vector<std::uint8_t> hidden_edge;

    /// The lit picture, and that of the same renderer given the true mask: 8 bits a channel, as a
    /// display shows them, at least 3 channels. Both empty when pictures were not made.
    engine::Image picture;
    engine::Image reference_picture;

    /// Technique and truth may agree on every pixel by right, because no edge of this scene comes
    /// near a pixel's centre. Otherwise an error below the precision floor raises the question of a
    /// copied truth.
    bool exact_by_construction = false;
};

/// How far from a true edge a picture through a grid may be wrong, px; never less than one pixel. A
/// texel that is dark for lit has its centre on the wrong side, 0.71 of a texel away at most.
/// @param texel_px pixels that one texel covers along the way in which they are most
/// @param shift_px how far an edge may move for other reasons
float resolution_band_px(double texel_px, double shift_px);

/// Every pixel valid.
/// @pre both masks have the same size
Comparison comparison(Mask measured, Mask truth, bool soft = false);

/// Aborts unless sizes agree.
void check_sizes(const Comparison& input);

/// The first channel of an 8-bit picture as visibility.
Mask mask_from_image(const engine::Image& image);

} // namespace measure
