// The figures that need one pass over the pixels, put together with those of edge_distance.cpp.

#include "tools/measure/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tools/measure/blobs.hpp"
#include "tools/measure/edge_distance.hpp"
#include "tools/measure/edges.hpp"
#include "tools/measure/flip.hpp"
#include "tools/measure/floors.hpp"
#include "tools/measure/ranks.hpp"

namespace measure {

namespace {

constexpr float kBandPx = 1.0F;
const char* const kNoValidPixels = "no valid pixels";
const char* const kFewEdges = "less than 32 px of true edge";

Figure ratio(double part, double whole, const char* reason) {
    return whole > 0.0 ? Figure(part / whole) : Figure::missing(reason);
}

bool wrong(const Comparison& input, std::size_t i) {
    return lit(input.measured.visibility[i]) != lit(input.truth.visibility[i]);
}

void add_pixel_counts(const Comparison& input, const DistanceField& to_edge, Figures& figures) {
    double surface = 0.0;
    double mismatch = 0.0;
    double undecided = 0.0;
    for (int y = 0; y < input.truth.height; ++y)
        for (int x = 0; x < input.truth.width; ++x) {
            const std::size_t i = input.truth.index(x, y);
            const PixelKind kind = input.kind[i];
            if (kind != PixelKind::empty) ++surface;
            if (kind == PixelKind::valid) ++figures.valid_px;
            if (kind == PixelKind::mismatch) ++mismatch;
            if (kind == PixelKind::undecided && to_edge.to_pixel(x, y) > kBandPx) ++undecided;
            if (kind != PixelKind::grazing) continue;
            ++figures.grazing_px;
            if (wrong(input, i)) ++figures.grazing_wrong_px;
        }
    figures.invalid_share = ratio(mismatch, surface, "no surface in the picture");
    figures.undecided_share = ratio(undecided, surface, "no surface in the picture");
}

/// 1 for valid pixels farther from every true edge than `radius_px(i)`.
template <class Radius>
std::vector<std::uint8_t>
beyond(const Comparison& input, const DistanceField& to_edge, Radius radius_px) {
    std::vector<std::uint8_t> marked(input.truth.pixel_count());
    for (int y = 0; y < input.truth.height; ++y)
        for (int x = 0; x < input.truth.width; ++x) {
            const std::size_t i = input.truth.index(x, y);
            if (input.kind[i] == PixelKind::valid && to_edge.to_pixel(x, y) > radius_px(i))
                marked[i] = 1;
        }
    return marked;
}

/// 1 for valid pixels whose distance to true edges is more than the technique's resolution excuses.
std::vector<std::uint8_t> beyond_band(const Comparison& input, const DistanceField& to_edge) {
    const std::vector<float>& band = input.resolution_band_px;
    std::vector<std::uint8_t> marked = beyond(input, to_edge, [&](std::size_t i) {
        return band.empty() ? kBandPx : std::max(kBandPx, band[band.size() == 1 ? 0 : i]);
    });
    for (std::size_t i = 0; i < input.hidden_edge.size(); ++i)
        if (input.hidden_edge[i] != 0) marked[i] = 0;
    return marked;
}

/// The wrong ones among marked pixels.
/// @param marked consumed
InteriorErrors
errors_among(const Comparison& input, double valid_px, std::vector<std::uint8_t> marked) {
    InteriorErrors errors;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked[i] == 0) continue;
        if (!wrong(input, i)) {
            marked[i] = 0;
            continue;
        }
        ++(lit(input.truth.visibility[i]) ? errors.false_shadow_px : errors.light_leak_px);
    }
    const Blobs blobs = find_blobs(input.truth.width, input.truth.height, std::move(marked));
    errors.largest_px = static_cast<double>(blobs.largest_px);
    errors.components = ratio(1000.0 * static_cast<double>(blobs.count), valid_px, kNoValidPixels);
    return errors;
}

void add_misclassification(
    const Comparison& input, const DistanceField& to_edge, Figures& figures) {
    for (std::size_t i = 0; i < input.kind.size(); ++i) {
        if (input.kind[i] != PixelKind::valid || !wrong(input, i)) continue;
        ++(lit(input.truth.visibility[i]) ? figures.false_shadow_px : figures.light_leak_px);
    }
    figures.interior = errors_among(
        input, figures.valid_px, beyond(input, to_edge, [](std::size_t) { return kBandPx; }));
}

/// Errors beyond the technique's own resolution.
void add_structure(const Comparison& input, const DistanceField& to_edge, Figures& figures) {
    std::vector<std::uint8_t> far = beyond_band(input, to_edge);
    const auto far_px = static_cast<double>(std::count(far.begin(), far.end(), 1));
    figures.band_share = ratio(figures.valid_px - far_px, figures.valid_px, kNoValidPixels);
    if (figures.valid_px > 0.0 && figures.band_share.value() > kMaxBandShare) {
        const Figure missing = Figure::missing(fmt::format(
            "not judged: more than {:.0f} % of the valid pixels lie within the resolution of a "
            "true edge",
            100.0 * kMaxBandShare));
        figures.far_false_shadow_px = figures.far_light_leak_px = figures.far_largest_px = missing;
        return;
    }
    const InteriorErrors errors = errors_among(input, figures.valid_px, std::move(far));
    figures.far_false_shadow_px = errors.false_shadow_px;
    figures.far_light_leak_px = errors.light_leak_px;
    figures.far_largest_px = errors.largest_px;
}

void add_visibility(const Comparison& input, Figures& figures) {
    double signed_error = 0.0;
    for (std::size_t i = 0; i < input.kind.size(); ++i) {
        if (input.kind[i] != PixelKind::valid) continue;
        const float truth = input.truth.visibility[i];
        const double error =
            static_cast<double>(input.measured.visibility[i]) - static_cast<double>(truth);
        figures.error_px += std::abs(error);
        signed_error += error;
        if (truth > 0.0F && truth < 1.0F) ++figures.penumbra_px;
    }
    figures.mean_error = ratio(figures.error_px, figures.valid_px, kNoValidPixels);
    const double edge_px = figures.edge_px < kMinEdgePx ? 0.0 : figures.edge_px;
    figures.eps_px = ratio(figures.error_px, edge_px, kFewEdges);
    figures.bias_px = ratio(signed_error, edge_px, kFewEdges);
}

/// Of what a display would show, in [0, 1]. Source: ITU-R BT.709 weights.
float luminance(const engine::Image& picture, std::size_t i) {
    const std::uint8_t* pixel =
        picture.bytes.data() + i * static_cast<std::size_t>(picture.channels);
    return (0.2126F * static_cast<float>(pixel[0]) + 0.7152F * static_cast<float>(pixel[1])
            + 0.0722F * static_cast<float>(pixel[2]))
           / 255.0F;
}

void add_pictures(const Comparison& input, Figures& figures) {
    if (input.picture.bytes.empty()) {
        const Figure missing = Figure::missing("no shaded pictures were compared");
        figures.double_dark_px = figures.flip_mean = figures.flip_p99 = missing;
        return;
    }
    double count = 0.0;
    for (std::size_t i = 0; i < input.kind.size(); ++i) {
        const bool unlit =
            input.kind[i] == PixelKind::facing_away
            || (input.kind[i] == PixelKind::valid && input.truth.visibility[i] == 0.0F);
        if (unlit
            && luminance(input.picture, i)
                   < luminance(input.reference_picture, i) - kDarkerThanReference)
            ++count;
    }
    figures.double_dark_px = count;
    std::vector<float> differences = flip(input.picture, input.reference_picture);
    figures.flip_mean = mean(differences);
    figures.flip_p99 = percentile(differences, 0.99);
}

void add_floors(const Comparison& input, Figures& figures) {
    if (figures.edge_px < kMinEdgePx) {
        const Figure missing = Figure::missing(kFewEdges);
        figures.precision_floor_px = figures.half_pixel_floor_px = missing;
        figures.over_precision_floor = figures.over_half_pixel_floor = missing;
        return;
    }
    const double value =
        input.soft ? figures.error_px : figures.false_shadow_px + figures.light_leak_px;
    const double precision =
        input.soft ? kSamplingFloor * figures.penumbra_px : kPrecisionFloor * figures.edge_px;
    const double half_pixel = kHalfPixelFloor * figures.edge_px;
    figures.precision_floor_px = precision;
    figures.half_pixel_floor_px = half_pixel;
    figures.over_precision_floor = ratio(value, precision, "the true mask has no penumbra");
    figures.over_half_pixel_floor = value / half_pixel;
    figures.copied_truth = !input.exact_by_construction && value < precision;
}

} // namespace

Figures compare(const Comparison& input) {
    check_sizes(input);
    const int width = input.truth.width;
    const int height = input.truth.height;
    const Edge truth = find_edge(input.truth, input.kind);
    const Edge measured = find_edge(input.measured, input.kind);

    Figures figures;
    figures.edge_px = crofton_length(truth.cracks.size());
    add_pixel_counts(input, truth.distance, figures);
    add_misclassification(input, truth.distance, figures);
    add_structure(input, truth.distance, figures);
    const EdgeDistance edges = edge_distance(measured, truth, std::hypot(width, height));
    figures.chamfer_px = edges.chamfer_px;
    figures.hausdorff95_px = edges.hausdorff95_px;
    figures.boundary_f1 = edges.boundary_f1;
    add_visibility(input, figures);
    add_pictures(input, figures);
    add_floors(input, figures);
    return figures;
}

std::vector<std::uint8_t> far_errors(const Comparison& input) {
    const Edge truth = find_edge(input.truth, input.kind);
    std::vector<std::uint8_t> marked = beyond_band(input, truth.distance);
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (!wrong(input, i)) marked[i] = 0;
    return marked;
}

std::vector<std::string> warnings(const Figures& figures) {
    std::vector<std::string> found;
    const auto gate = [&](const Figure& share, double allowed, const char* what) {
        if (share.known() && share.value() >= allowed)
            found.push_back(fmt::format(
                "{:.2f} % of pixels {}, {:.1f} % allowed",
                100.0 * share.value(),
                what,
                100.0 * allowed));
    };
    gate(figures.invalid_share, kMaxInvalidShare, "show another surface than the truth");
    gate(figures.undecided_share, kMaxUndecidedShare, "have no sure truth");
    if (figures.copied_truth) found.emplace_back("below the precision floor: copied truth?");
    return found;
}

} // namespace measure
