#include "systems/shadows/maps/map_error.hpp"

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/screen_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// Share of a penumbra that its guessed width costs.
constexpr double kSoftWidthError = 0.01;

/// Look-ups of MapFilter::pcf, each of four texels.
constexpr double kPcfTaps = (kPcfWidth + 1) * (kPcfWidth + 1) / 4.0;

/// Cosine between a flat receiver and the light; the mean over all directions for other receivers.
double cosine_at(const PairView& pair) {
    if (!pair.receiver.flat) return 0.7;
    const LightView& light = pair.light;
    const glm::dvec3 travels = light.light.kind == scene::LightKind::directional
                                   ? glm::dvec3(light.direction)
                                   : glm::normalize(pair.receiver.bounds.centre() - light.position);
    return std::clamp(std::abs(glm::dot(pair.receiver.normal, travels)), 0.02, 1.0);
}

double pixels_per_metre(const PairView& pair) {
    const scene::CameraView& camera = pair.scene.camera;
    return 1.0 / (typical_distance(camera, pair.receiver.bounds) * camera.pixel_size());
}

/// What a soft filter's texels do: no edge gets sharper than a texel, and neighbours are alike.
double soft_texel_error_px(double footprint_px, double penumbra) {
    const double sharpest = ramp_texels(MapFilter::pcss) * footprint_px;
    return std::max(sharpest - penumbra, 0.0) * 0.25 + 0.1 * footprint_px;
}

double error_px(MapFilter filter, double footprint_px, double penumbra, int taps) {
    if (penumbra == 0.0) return edge_error_texels(filter) * footprint_px;
    if (filter == MapFilter::pcss)
        return soft_texel_error_px(footprint_px, penumbra)
               + penumbra * (kSoftWidthError + 0.35 * std::pow(taps, -0.75));
    // Two centred ramps. A hard edge for a soft light differs by a quarter of its penumbra.
    return std::abs(ramp_texels(filter) * footprint_px - penumbra) * 0.25;
}

} // namespace

int soft_taps(const scene::ShadowWish& wish) {
    return std::clamp(wish.samples.value_or(kSoftTaps), 4, 256);
}

bool is_hard(const scene::Light& light) {
    return light.kind == scene::LightKind::directional ? light.angular_radius == 0.0F
                                                       : light.radius == 0.0F;
}

engine::Result<MapFilter>
map_filter(const PairView& pair, const CasterGroup& casters, double texel_m_of_one) {
    const bool hard = is_hard(pair.light.light);
    const auto& name = pair.wish.filter;
    if (!name) {
        if (hard) return MapFilter::bilinear;
        const int size = map_size_for(pair, casters, MapFilter::bilinear, texel_m_of_one);
        const double footprint = texel_footprint_px(pair, texel_m_of_one) / size;
        const double error =
            error_px(MapFilter::bilinear, footprint, penumbra_px(pair, casters), 0);
        return error > pair.budget_px ? MapFilter::pcss : MapFilter::bilinear;
    }
    if (*name == "nearest") return MapFilter::nearest;
    if (*name == "bilinear") return MapFilter::bilinear;
    if (*name == "pcf") return MapFilter::pcf;
    if (*name == "pcss") return hard ? MapFilter::bilinear : MapFilter::pcss;
    return engine::Error{fmt::format("maps cannot be filtered by '{}'", *name)};
}

int filter_border(MapFilter filter) {
    switch (filter) {
    case MapFilter::nearest:
        return 1;
    case MapFilter::bilinear:
        return 1;
    case MapFilter::pcss: // beside its penumbra
        return 2;
    case MapFilter::pcf:
        break;
    }
    return kPcfWidth / 2 + 1;
}

double filter_reach(MapFilter filter) {
    switch (filter) {
    case MapFilter::nearest:
        return 0.5;
    case MapFilter::bilinear:
        return 1.0;
    case MapFilter::pcss: // at least
        return 2.0;
    case MapFilter::pcf:
        break;
    }
    return 0.5 * (kPcfWidth + 1);
}

double edge_error_texels(MapFilter filter) {
    switch (filter) {
    case MapFilter::nearest:
        return 0.2422;
    case MapFilter::bilinear:
        return 0.332;
    case MapFilter::pcss: // a disc of one texel's radius, of bilinear taps
        return 0.50;
    case MapFilter::pcf:
        break;
    }
    return 0.762;
}

double ramp_texels(MapFilter filter) {
    switch (filter) {
    case MapFilter::nearest:
        return 0.0;
    case MapFilter::bilinear:
        return 1.33;
    case MapFilter::pcss: // at least
        return 2.0;
    case MapFilter::pcf:
        break;
    }
    return 3.05;
}

double texel_footprint_px(const PairView& pair, double texel_m) {
    // The mean over the directions of an edge.
    return texel_m / std::sqrt(cosine_at(pair)) * pixels_per_metre(pair);
}

double length_px(const PairView& pair, double across_m) {
    return across_m / cosine_at(pair) * pixels_per_metre(pair);
}

double penumbra_px(const PairView& pair, const CasterGroup& casters) {
    const LightView& light = pair.light;
    const glm::dvec3 between = pair.receiver.bounds.centre() - casters.bounds.centre();
    double width_m = 0.0;
    if (light.light.kind == scene::LightKind::directional) {
        const double behind = std::max(glm::dot(between, glm::dvec3(light.direction)), 0.0);
        width_m = 2.0 * std::tan(static_cast<double>(light.light.angular_radius)) * behind;
    } else {
        const double before = std::max(glm::length(casters.bounds.centre() - light.position), 1e-3);
        width_m = 2.0 * static_cast<double>(light.light.radius) * glm::length(between) / before;
    }
    return length_px(pair, width_m);
}

int map_size_for(
    const PairView& pair, const CasterGroup& casters, MapFilter filter, double texel_m_of_one) {
    if (pair.wish.map_size) return *pair.wish.map_size;
    const double penumbra = penumbra_px(pair, casters);
    const double footprint = texel_footprint_px(pair, texel_m_of_one);
    // More texels do not make up for a penumbra that is missing, or for too few taps.
    const auto is_coarse = [&](double texel_px) {
        if (filter == MapFilter::pcss)
            return soft_texel_error_px(texel_px, penumbra) > 0.5 * pair.budget_px;
        return error_px(filter, texel_px, penumbra, 0) > pair.budget_px;
    };
    int size = kSmallestMap;
    while (size < kLargestMap && is_coarse(footprint / size))
        size *= 2;
    return size;
}

engine::Result<Prediction>
predict_map(const PairView& pair, const CasterGroup& casters, double texel_m_of_one, int layers) {
    const auto wished = map_filter(pair, casters, texel_m_of_one);
    if (!wished) return wished.error();
    const MapFilter filter = *wished;
    const int size = map_size_for(pair, casters, filter, texel_m_of_one);
    const double footprint = texel_footprint_px(pair, texel_m_of_one) / size;
    const double penumbra = penumbra_px(pair, casters);
    const int taps = soft_taps(pair.wish);
    const ShadowFootprint shadow = shadow_footprint(pair, casters);
    const double area = screen_area_px(pair.scene.camera, pair.receiver.bounds);
    Prediction prediction;
    prediction.error_px = error_px(filter, footprint, penumbra, taps);
    prediction.error_area_px = prediction.error_px * shadow.length_px;
    prediction.cost.taps = area * (filter == MapFilter::pcf ? kPcfTaps : 1);
    if (filter == MapFilter::pcss) // All look for blockers, and what finds one looks again.
        prediction.cost.taps =
            area * search_taps(taps)
            + std::min(area, shadow.area_px + 0.5 * penumbra * shadow.length_px) * taps;
    prediction.cost.vertices = static_cast<double>(casters.triangles) * 1.5;
    // Clearing and filling are shared by every pair of the light.
    prediction.cost.map_texels = static_cast<double>(size) * size * layers
                                 / static_cast<double>(pair.scene.receivers.size());
    prediction.cost.draws = 1.0;
    return prediction;
}

} // namespace shadows
