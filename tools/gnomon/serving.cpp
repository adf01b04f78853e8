#include "tools/gnomon/serving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gnomon {

Serving::Serving(const shadows::ShadowSystem& shadows, std::size_t light) {
    const std::uint32_t id = shadows.scene().lights[light].id;
    for (const shadows::Plan& plan : shadows.plan().plans) {
        if (plan.light != id) continue;
        Server& server = by_receiver_[plan.receiver];
        for (const shadows::PlanEntry& entry : plan.entries) {
            if (!server.techniques.empty()) server.techniques += "+";
            server.techniques += entry.technique;
            if (const shadows::ShadowJob* job = shadows.job(id, entry.technique))
                server.jobs.push_back(job);
        }
    }
}

std::vector<float> Serving::bands_px(
    const DrawnSurfaces& drawn,
    const truth::TruthImage& truth,
    const scene::CameraView& camera) const {
    const trace::VisibilityImage& image = truth.image;
    std::vector<float> bands(image.pixel_count(), measure::resolution_band_px(0.0, 0.0));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            const auto server = by_receiver_.find(drawn.receiver[pixel]);
            if (server == by_receiver_.end() || image.n_dot_l[pixel] <= 0.0F) continue;
            const shadows::SurfacePoint point = {
                camera.position
                    + camera.ray_direction(x + 0.5, y + 0.5)
                          * static_cast<double>(image.depth[pixel]),
                image.normal[pixel]};
            shadows::Resolution coarsest;
            for (const shadows::ShadowJob* job : server->second.jobs)
                coarsest = shadows::coarser(coarsest, job->resolution(camera, point));
            bands[pixel] = measure::resolution_band_px(coarsest.texel_px, coarsest.shift_px);
        }
    return bands;
}

std::string
Serving::shares(const DrawnSurfaces& drawn, const measure::Comparison& comparison) const {
    std::map<std::string, std::size_t> counts;
    std::size_t valid = 0;
    for (std::size_t pixel = 0; pixel < comparison.kind.size(); ++pixel) {
        if (comparison.kind[pixel] != measure::PixelKind::valid) continue;
        const auto server = by_receiver_.find(drawn.receiver[pixel]);
        ++counts[server == by_receiver_.end() ? "unpaired" : server->second.techniques];
        ++valid;
    }
    std::vector<std::pair<std::size_t, std::string>> sorted;
    for (const auto& [techniques, count] : counts)
        sorted.emplace_back(count, techniques);
    std::sort(sorted.rbegin(), sorted.rend());
    std::string text;
    for (const auto& [count, techniques] : sorted)
        text += fmt::format(
            "{}{} {:.1f} %",
            text.empty() ? "" : ", ",
            techniques,
            100.0 * static_cast<double>(count) / static_cast<double>(valid));
    return text;
}

} // namespace gnomon
