#include "tools/measure/mask.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace measure {

PixelKind classify(const PixelEvidence& evidence) {
    if (evidence.measured_entity == 0 && evidence.truth_entity == 0) return PixelKind::empty;
    if (evidence.measured_entity != evidence.truth_entity) return PixelKind::mismatch;
    const float difference = std::abs(evidence.measured_depth - evidence.truth_depth);
    // Written so that a depth that is not a number does not match either.
    const bool same_depth = evidence.measured_depth == evidence.truth_depth
                            || difference < kDepthTolerance * evidence.truth_depth;
    if (!same_depth) return PixelKind::mismatch;
    if (evidence.n_dot_l <= 0.0F) return PixelKind::facing_away;
    if (evidence.n_dot_l <= kGrazingCosine) return PixelKind::grazing;
    return evidence.undecided ? PixelKind::undecided : PixelKind::valid;
}

float resolution_band_px(double texel_px, double shift_px) {
    return static_cast<float>(std::max(1.0, 0.75 * texel_px + shift_px));
}

Comparison comparison(Mask measured, Mask truth, bool soft) {
    Comparison input;
    input.kind.assign(truth.pixel_count(), PixelKind::valid);
    input.measured = std::move(measured);
    input.truth = std::move(truth);
    input.soft = soft;
    check_sizes(input);
    return input;
}

void check_sizes(const Comparison& input) {
    const std::size_t count = input.truth.pixel_count();
    CHECK_EQ(input.truth.width, input.measured.width);
    CHECK_EQ(input.truth.height, input.measured.height);
    CHECK_EQ(
        count,
        static_cast<std::size_t>(input.truth.width) * static_cast<std::size_t>(input.truth.height));
    CHECK_EQ(input.measured.pixel_count(), count);
    CHECK_EQ(input.kind.size(), count);
    CHECK(input.resolution_band_px.size() <= 1 || input.resolution_band_px.size() == count);
    CHECK(input.hidden_edge.empty() || input.hidden_edge.size() == count);
    CHECK_EQ(input.picture.pixel_count(), input.reference_picture.pixel_count());
    CHECK(input.picture.bytes.empty() || input.picture.pixel_count() == count);
}

Mask mask_from_image(const engine::Image& image) {
    Mask mask(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            mask.at(x, y) = static_cast<float>(*image.at(x, y)) / 255.0F;
    return mask;
}

} // namespace measure
