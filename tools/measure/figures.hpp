// The figures of one still picture: how wrong the shadows of one light are, and in what way.
//
// Errors are split by place. Within one pixel of a true edge an error is aliasing and scales with
// resolution; in the interior it is a wrong picture. The one currency across techniques is eps, the
// area of wrong visibility per px of true edge: it depends neither on the size of the picture nor
// on how much of it is in shadow.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "tools/measure/figure.hpp"
#include "tools/measure/mask.hpp"

namespace measure {

/// Wrong pixels of a region away from edges.
struct InteriorErrors {
    double false_shadow_px = 0.0;
    double light_leak_px = 0.0;
    double largest_px = 0.0; ///< the largest connected region: a wrong shape
    Figure components;       ///< regions per 1000 valid px: many with a small largest_px are acne
};

struct Figures {
    // What could be compared.
    double valid_px = 0.0;
    Figure invalid_share;    ///< mismatched silhouettes / pixels with a surface
    Figure undecided_share;  ///< undecided farther than 1 px from an edge / pixels with a surface
    double grazing_px = 0.0; ///< lit by less than one degree: in no other figure
    double grazing_wrong_px = 0.0;
    double edge_px = 0.0;     ///< true edge length, L*
    double penumbra_px = 0.0; ///< pixels with a true visibility strictly between 0 and 1

    // Misclassified: dark for lit, lit for dark.
    double false_shadow_px = 0.0;
    double light_leak_px = 0.0;
    InteriorErrors interior; ///< farther than 1 px from every true edge
    Figure band_share; ///< valid pixels no farther from a true edge than the technique's resolution
    /// Beyond that band: a wrong picture. Not judged where the band covers most of what could be.
    Figure far_false_shadow_px;
    Figure far_light_leak_px;
    Figure far_largest_px;

    // Distance between the edges.
    Figure chamfer_px;
    Figure hausdorff95_px;
    Figure boundary_f1; ///< harmonic mean of the shares of each edge within 1 px of the other

    // Visibility.
    double error_px = 0.0; ///< sum of |V - V*|
    Figure eps_px;         ///< error_px / edge_px
    Figure bias_px;        ///< signed: positive is too much light
    Figure mean_error;     ///< error_px / valid_px

    // The lit pictures, shaded with the technique's mask and with the true one.
    Figure flip_mean;      ///< how different they look, 0 to 1: see flip.hpp
    Figure flip_p99;       ///< 99th percentile of the same over the pixels
    Figure double_dark_px; ///< darker than shading with the true mask, where no light falls anyway

    // How good it could be, in the unit of what is compared with it: wrong pixels of a hard light,
    // error_px of a soft one.
    Figure precision_floor_px;
    Figure half_pixel_floor_px;
    Figure over_precision_floor; ///< value / floor
    Figure over_half_pixel_floor;
    bool copied_truth = false; ///< better than can be: look for a truth that was copied
};

/// Errors: none; figures that cannot be computed carry the reason.
/// Cost: linear in pixels, two distance transforms at twice the resolution,
/// and flip() when there are pictures.
Figures compare(const Comparison& input);

/// 1 for each pixel that the figures called far count, judged or not.
std::vector<std::uint8_t> far_errors(const Comparison& input);

/// Gates that were not passed and doubts, one sentence each.
std::vector<std::string> warnings(const Figures& figures);

/// One object with a key per figure; figures without a value are null, with the reason under
/// "missing".
nlohmann::json to_json(const Figures& figures);

} // namespace measure
