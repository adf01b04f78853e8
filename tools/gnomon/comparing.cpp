#include "tools/gnomon/comparing.hpp"

#include <algorithm>
#include <cmath>

#include "tools/measure/figures.hpp"

namespace gnomon {

namespace {

/// The figures call "no surface" 0; entities count from 0.
std::uint32_t surface_number(std::uint32_t entity) {
    return entity == ecs::kNoEntity.value ? 0 : entity + 1;
}

measure::PixelEvidence
evidence_at(std::size_t pixel, const truth::TruthImage& truth, const DrawnSurfaces& drawn) {
    measure::PixelEvidence evidence;
    evidence.measured_entity = surface_number(drawn.entity[pixel]);
    evidence.truth_entity = surface_number(truth.image.entity[pixel]);
    evidence.measured_depth = drawn.depth[pixel];
    evidence.truth_depth = truth.image.depth[pixel];
    evidence.n_dot_l = truth.image.n_dot_l[pixel];
    evidence.undecided = truth.undecided[pixel] != 0;
    return evidence;
}

} // namespace

DrawnSurfaces drawn_surfaces(Studio& studio, const scene::CameraView& camera) {
    DrawnSurfaces drawn;
    drawn.depth = studio.view_depth(camera);
    const scene::ReceiverTable& receivers = studio.renderer().receivers();
    std::vector<std::uint32_t> entity_of(receivers.end(), ecs::kNoEntity.value);
    for (const scene::ReceiverRange& range : receivers.ranges())
        std::fill_n(entity_of.begin() + range.first, range.count, range.entity.value);
    Studio::Surfaces surfaces = studio.surfaces();
    drawn.receiver = std::move(surfaces.receiver);
    drawn.normal = std::move(surfaces.normal);
    for (const std::uint32_t id : drawn.receiver)
        drawn.entity.push_back(entity_of[id]);
    return drawn;
}

bool is_soft(const scene::Light& light) {
    return light.radius > 0.0F || light.angular_radius > 0.0F;
}

measure::Comparison make_comparison(
    const engine::Image& mask,
    const truth::TruthImage& truth,
    const DrawnSurfaces& drawn,
    const scene::CameraView& camera,
    const scene::PlacedLight& light) {
    measure::Mask true_mask(truth.image.width, truth.image.height);
    true_mask.visibility = truth.image.visibility;
    measure::Comparison comparison = measure::comparison(
        measure::mask_from_image(mask), std::move(true_mask), is_soft(light.light));
    for (int y = 0; y < truth.image.height; ++y)
        for (int x = 0; x < truth.image.width; ++x) {
            const std::size_t pixel = truth.image.index(x, y);
            measure::PixelEvidence evidence = evidence_at(pixel, truth, drawn);
            const glm::dvec3 place =
                camera.ray_direction(x + 0.5, y + 0.5) * static_cast<double>(evidence.truth_depth);
            const glm::vec3 to_light(light.position - camera.position - place);
            const glm::vec3 towards =
                light.light.kind == scene::LightKind::directional ? -light.direction : to_light;
            evidence.n_dot_l =
                std::min(evidence.n_dot_l, glm::dot(drawn.normal[pixel], glm::normalize(towards)));
            if (evidence.truth_entity != 0 && !(scene::illuminance_at(light, to_light) > 0.0F))
                evidence.n_dot_l = 0.0F;
            comparison.kind[pixel] = measure::classify(evidence);
        }
    return comparison;
}

void find_hidden_edges(
    const trace::TraceScene& tracer,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    measure::Comparison& comparison) {
    constexpr std::ptrdiff_t kMostPixels = 4096;
    const std::vector<std::uint8_t> far = measure::far_errors(comparison);
    if (std::count(far.begin(), far.end(), 1) > kMostPixels) return;
    comparison.hidden_edge.assign(far.size(), 0);
    trace::for_each_row(camera.height, 0, nullptr, [&](int y) {
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t pixel = comparison.truth.index(x, y);
            if (far[pixel] == 0) continue;
            const bool found = truth::edge_near(
                tracer,
                camera,
                light,
                {x + 0.5, y + 0.5},
                measure::lit(comparison.truth.visibility[pixel]),
                static_cast<double>(comparison.resolution_band_px[pixel]),
                static_cast<double>(measure::kGrazingCosine));
            comparison.hidden_edge[pixel] = found ? 1 : 0;
        }
    });
}

} // namespace gnomon
