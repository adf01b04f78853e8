#include "systems/shadows/techniques/map_job.hpp"

#include "engine/gpu/pass.hpp"
#include "engine/render/light_visibility.hpp"
#include "systems/shadows/maps/map_view.hpp"
#include "systems/shadows/techniques/depth_draws.hpp"
#include "systems/shadows/techniques/rectangles.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

#include <algorithm>
#include <set>

namespace shadows {

namespace {

std::string filter_define(MapFilter filter) {
    switch (filter) {
    case MapFilter::nearest:
        return "FILTER_NEAREST";
    case MapFilter::bilinear:
        return "FILTER_BILINEAR";
    case MapFilter::pcf:
        return "FILTER_PCF";
    case MapFilter::pcss:
        break;
    }
    return "FILTER_PCSS";
}

/// At most.
std::uint64_t looks_per_pixel(MapFilter filter, int soft_taps) {
    if (filter == MapFilter::pcf) return 4;
    if (filter != MapFilter::pcss) return 1;
    return static_cast<std::uint64_t>(search_taps(soft_taps) + soft_taps);
}

/// What the mask is compiled for where remedies are off.
void append_naive_ways(const Remedies& remedies, gpu::Defines& defines) {
    const auto without = [&](Remedy remedy, const char* define) {
        if (!remedies.on(remedy)) defines.emplace_back(define);
    };
    without(Remedy::map_receiver_plane, "FLAT_DEPTH");
    without(Remedy::map_open_creases, "CLOSED_CREASES");
    without(Remedy::map_no_constant_bias, "CONSTANT_BIAS=0.2");
    without(Remedy::map_kernel_plane, "BIAS_OF_ONE_TEXEL");
    without(Remedy::map_no_normal_offset, "FLAT_DEPTH");
    without(Remedy::map_no_normal_offset, "NORMAL_OFFSET=2.0");
    without(Remedy::map_exact_facets, "GUESSED_FACETS");
    without(Remedy::map_fine_depth, "DEPTH_STEPS=255.0");
}

} // namespace

std::vector<std::uint32_t> groups_of(const ShadowRequest& request, std::string_view technique) {
    std::set<std::uint32_t> groups;
    for (const Plan* plan : request.plans)
        for (const PlanEntry& entry : plan->entries)
            if (entry.technique == technique)
                groups.insert(entry.caster_groups.begin(), entry.caster_groups.end());
    return {groups.begin(), groups.end()};
}

engine::Result<void> MapJob::update(const ShadowRequest& request) {
    light_ = request.scene.lights[request.light];
    remedies_ = request.remedies;
    serves_all_ = request.serves_all;
    camera_ = request.scene.camera;
    soft_taps_ = soft_taps(request.wish);
    casters_.clear();
    bounds_.clear();
    for (const std::uint32_t group : groups_of(request, technique_)) {
        bounds_.push_back(request.groups[group].bounds);
        for (const std::uint32_t caster : request.groups[group].casters)
            casters_.push_back(request.scene.casters[caster].id);
    }
    std::sort(casters_.begin(), casters_.end());
    receivers_.assign(request.plans, request.receiver_end);
    served_ = {};
    for (const Plan* plan : request.plans)
        served_.grow(request.scene.receiver(plan->receiver).bounds);
    if (auto chosen = choose(request); !chosen) return chosen;
    fit(request, size_);
    return {};
}

engine::Result<void> MapJob::choose(const ShadowRequest& request) {
    filter_ = MapFilter::nearest;
    size_ = kSmallestMap;
    for (const Plan* plan : request.plans) {
        const ReceiverView& receiver = request.scene.receiver(plan->receiver);
        const PairView pair{request.scene, light_, receiver, request.wish, plan->budget_px};
        const double texel_m = texel_m_of_one(pair);
        for (const PlanEntry& entry : plan->entries) {
            if (entry.technique != technique_) continue;
            for (const std::uint32_t group : entry.caster_groups) {
                const CasterGroup& casters = request.groups[group];
                const auto filter = map_filter(pair, casters, texel_m);
                if (!filter) return filter.error();
                filter_ = std::max(filter_, *filter);
                size_ = std::max(size_, map_size_for(pair, casters, *filter, texel_m));
            }
        }
    }
    if (!remedies_.on(Remedy::map_needed_texels)) size_ = kSmallestMap;
    size_ = request.wish.map_size.value_or(size_);
    return {};
}

void MapJob::add_soft_defines(gpu::Defines& defines) const {
    defines.push_back(fmt::format("FILTER_TAPS={}", soft_taps_));
    defines.push_back(fmt::format("SEARCH_TAPS={}", search_taps(soft_taps_)));
    if (!remedies_.on(Remedy::soft_scaled_search)) defines.emplace_back("SHORT_SEARCH");
    if (!remedies_.on(Remedy::soft_clusters)) defines.emplace_back("ONE_CLUSTER");
    if (!remedies_.on(Remedy::soft_width)) defines.emplace_back("ONE_WIDTH");
}

engine::Result<void> MapJob::resize() {
    if (map_ && map_.width() == size_ && map_.layers() == layers()) return {};
    layers_.clear();
    map_ = gpu::Texture(
        fmt::format("{}/{}", light_.name, technique_),
        {.kind = gpu::TextureKind::array,
         .format = gpu::Format::depth32f,
         .width = size_,
         .height = size_,
         .layers = layers(),
         // The border is infinitely far: lit.
         .sampling = {.wrap = gpu::Wrap::clamp_to_border}});
    for (int layer = 0; layer < layers(); ++layer) {
        auto target = gpu::Framebuffer::make(
            fmt::format("{}/{} {}", light_.name, technique_, layer),
            {.depth = gpu::Attachment{&map_, 0, layer}});
        if (!target) return target.error();
        layers_.push_back({*std::move(target), nullptr});
    }
    return {};
}

engine::Result<void>
MapJob::render(gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) {
    if (auto sized = resize(); !sized) return sized;
    for (int layer = 0; layer < layers(); ++layer)
        if (auto drawn = render_layer(frame, shaders, geometry, layer); !drawn) return drawn;
    gpu::Defines defines = mask_defines();
    defines.push_back(filter_define(filter_));
    if (filter_ == MapFilter::pcf) defines.push_back(fmt::format("PCF_WIDTH={}", kPcfWidth));
    if (filter_ == MapFilter::pcss) add_soft_defines(defines);
    if (serves_all_) defines.emplace_back("EVERY_RECEIVER");
    append_naive_ways(remedies_, defines);
    const auto mask = shaders.graphics("shadows/map_mask.vert", "shadows/map_mask.frag", defines);
    if (!mask) return mask.error();
    mask_ = *mask;
    return {};
}

engine::Result<void> MapJob::render_layer(
    gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry, int layer) {
    const bool local = light_.light.kind != scene::LightKind::directional;
    // Instances lie relative to something near, so that floats are enough.
    const glm::dvec3 origin = local ? light_.position : camera_.position;
    const std::optional<glm::dvec3> eye = local ? std::optional(light_.position) : std::nullopt;
    const glm::mat4 seen = camera_.clip_from_relative();
    std::vector<const render::DrawItem*> items;
    for (const render::DrawItem& item : geometry.items) {
        if (!std::binary_search(casters_.begin(), casters_.end(), item.entity.value)) continue;
        if (!reaches(layer, item.bounds)) continue;
        items.push_back(&item);
    }
    if (!remedies_.on(Remedy::map_swept_casters))
        std::erase_if(items, [&](const render::DrawItem* item) {
            return !engine::frustum_from_clip(seen).intersects(
                engine::relative_to(item->bounds, camera_.position));
        });
    const render::DrawList list =
        render::build_caster_list(items, geometry.world.assets, geometry.pool, origin, eye);
    Layer& into = layers_[static_cast<std::size_t>(layer)];
    if (into.draws == nullptr)
        into.draws = std::make_unique<render::DrawRuns>(technique_, geometry.pool);
    into.draws->upload(list);
    const glm::dmat4 from_origin = glm::translate(glm::dmat4(1.0), origin);
    const glm::mat4 clip_from_relative(clip_from_map() * map_from_world(layer) * from_origin);

    const gpu::ScopedPass pass(
        frame, fmt::format("{}/{}/render", light_.name, technique_), into.target, {.depth = 0.0F});
    frame.counters().map_texels +=
        static_cast<std::uint64_t>(size_) * static_cast<std::uint64_t>(size_);
    return draw_depth(
        frame,
        shaders,
        geometry.textures,
        *into.draws,
        list,
        clip_from_relative,
        {.pancaking = remedies_.on(Remedy::map_pancaking)
                      && (!local || remedies_.on(Remedy::map_near_casters)),
         .per_vertex = !remedies_.on(Remedy::map_fragment_pancaking),
         .back_faces = !remedies_.on(Remedy::map_front_faces),
         .holes = remedies_.on(Remedy::caster_holes)});
}

void MapJob::apply(
    gpu::Frame& frame, const scene::CameraView& camera, const render::VisibilityTarget& target) {
    const gpu::Rect area = intersection(target.area, to_rect(screen_bounds(camera, served_)));
    if (area.empty()) return;
    const gpu::ScopedPass pass(
        frame, fmt::format("{}/{}/mask", light_.name, technique_), target.mask);
    gpu::RenderState state = gpu::kScreenState;
    state.blend = gpu::Blend::min;
    state.scissor = area;
    frame.state(state);
    place(*mask_, camera);
    receivers_.bind();
    target.gbuffer.bind(UNIT_GBUFFER);
    target.facets.bind(UNIT_FACETS);
    target.depth.bind(UNIT_DEPTH);
    map_.bind(UNIT_VISIBILITY);
    frame.draw_fullscreen(*mask_);
    const auto pixels =
        static_cast<std::uint64_t>(area.width) * static_cast<std::uint64_t>(area.height);
    frame.counters().mask_fragments += pixels;
    frame.counters().taps += pixels * looks_per_pixel(filter_, soft_taps_);
}

} // namespace shadows
