#include "systems/shadows/techniques/group_textures.hpp"

#include "systems/shadows/techniques/rectangles.hpp"

#include <algorithm>

namespace shadows {

engine::Result<void> GroupTextures::update(
    const ShadowRequest& request,
    const CasterGroup& casters,
    const std::vector<const Plan*>& plans,
    const std::vector<LightView>& points,
    int size) {
    const ShadowScene& scene = request.scene;
    remedies_ = request.remedies;
    receivers_.assign(plans, request.receiver_end);
    reaches_.clear();
    textures_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (auto updated = textures_[i].update(request, points[i], casters, size); !updated)
            return updated;
        for (const Plan* plan : plans)
            if (const auto reach =
                    swept_reach(points[i], casters.bounds, scene.receiver(plan->receiver).bounds))
                reaches_.push_back(*reach);
    }
    return {};
}

engine::Result<void> GroupTextures::render(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const render::Geometry& geometry,
    TextureSamples& samples) {
    gpu::Defines defines = textures_.front().mask_defines();
    if (std::any_of(textures_.begin(), textures_.end(), [](const CasterTexture& texture) {
            return texture.catches();
        }))
        defines.emplace_back("CAUGHT");
    if (is_soft()) defines.emplace_back("SUMMED");
    const auto mask =
        shaders.graphics("shadows/map_mask.vert", "shadows/texture_mask.frag", defines);
    if (!mask) return mask.error();
    mask_ = *mask;
    for (CasterTexture& texture : textures_)
        if (auto drawn = texture.render(frame, shaders, geometry, samples); !drawn) return drawn;
    return {};
}

std::vector<gpu::Rect>
GroupTextures::areas(const scene::CameraView& camera, const gpu::Rect& whole) const {
    // Without its remedy a caster is projected where its bounds never go.
    if (!remedies_.on(Remedy::texture_before_light) || !remedies_.on(Remedy::texture_border)
        || !remedies_.on(Remedy::texture_behind_only))
        return {whole};
    std::vector<gpu::Rect> areas;
    gpu::Rect round;
    std::uint64_t sum = 0;
    for (const SweptReach& reach : reaches_) {
        const gpu::Rect area = intersection(to_rect(swept_pixels(camera, {reach})), whole);
        if (area.empty()) continue;
        areas.push_back(area);
        round = hull(round, area);
        sum += pixels(area);
    }
    if (areas.size() > 1 && pixels(round) <= sum) return {round};
    return areas;
}

void GroupTextures::look_up(
    gpu::Frame& frame,
    const scene::CameraView& camera,
    std::size_t point,
    std::span<const gpu::Rect> areas,
    const gpu::RenderState& state) const {
    receivers_.bind();
    textures_[point].look_up(frame, *mask_, camera, areas, state);
}

std::size_t GroupTextures::gpu_bytes() const {
    std::size_t sum = 0;
    for (const CasterTexture& texture : textures_)
        sum += texture.gpu_bytes();
    return sum;
}

} // namespace shadows
