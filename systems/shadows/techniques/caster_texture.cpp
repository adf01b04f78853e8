#include "systems/shadows/techniques/caster_texture.hpp"

#include "engine/gpu/pass.hpp"
#include "systems/shadows/techniques/depth_draws.hpp"
#include "systems/shadows/techniques/map_uniforms.hpp"
#include "systems/shadows/techniques/rectangles.hpp"
#include "systems/shadows/textures/texture_prediction.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

#include <algorithm>
#include <set>

namespace shadows {

namespace {

/// Texels that stay empty on each side: the edge of what is filtered.
constexpr int kBorder = 1;

bool is_local(const LightView& light) {
    return light.light.kind != scene::LightKind::directional;
}

} // namespace

engine::Result<const TextureSamples::Samples*> TextureSamples::get(int size, int layer) {
    Samples& samples = by_size_[{size, layer}];
    if (samples.depth) return &samples;
    const std::string label = fmt::format("shadow_texture samples {}", size);
    samples.depth =
        gpu::Texture(label, {.format = gpu::Format::depth32f, .width = size, .height = size});
    auto target = gpu::Framebuffer::make(label, {.depth = gpu::Attachment{&samples.depth}});
    if (!target) return target.error();
    samples.target = *std::move(target);
    return &samples;
}

std::size_t TextureSamples::gpu_bytes() const {
    std::size_t sum = 0;
    for (const auto& [size, samples] : by_size_)
        sum += samples.depth.size_bytes();
    return sum;
}

bool CasterTexture::DrawnFrom::operator==(const DrawnFrom& other) const {
    return size == other.size && casters == other.casters && catchers == other.catchers
           && poses == other.poses && map_from_world(view) == map_from_world(other.view);
}

engine::Result<void> CasterTexture::update(
    const ShadowRequest& request, const LightView& light, const CasterGroup& casters, int size) {
    const ShadowScene& scene = request.scene;
    light_ = light;
    origin_ = is_local(light_) ? light_.position : scene.camera.position;
    DrawnFrom from;
    from.size = size;
    const auto& registry = request.world.registry;
    const auto add = [&](std::vector<Placed>& list, std::uint32_t id) {
        const ecs::Entity entity{id};
        list.push_back({id, registry.get<scene::WorldTransform>(entity).world_from_local});
        if (registry.try_get<scene::PosedMesh>(entity) != nullptr)
            from.poses = registry.version<scene::PosedMesh>();
    };
    std::vector<engine::WorldAabb> bounds;
    for (const std::uint32_t index : casters.casters) {
        bounds.push_back(scene.casters[index].bounds);
        add(from.casters, scene.casters[index].id);
    }
    engine::WorldAabb behind;
    if (!scene.everything_casts && request.remedies.on(Remedy::texture_first_receiver)) {
        std::set<std::uint32_t> catchers;
        for (const ReceiverView& receiver : scene.receivers) {
            if (receiver.casts || !can_shadow(light_, casters.bounds, receiver.bounds)) continue;
            behind.grow(receiver.bounds);
            catchers.insert(receiver.entity);
        }
        for (const std::uint32_t entity : catchers)
            add(from.catchers, entity);
    }
    std::sort(from.casters.begin(), from.casters.end(), [](const Placed& a, const Placed& b) {
        return a.entity < b.entity;
    });
    const int border = request.remedies.on(Remedy::texture_border) ? kBorder : 0;
    auto view = fit_texture(light_, bounds, behind, size, border, request.remedies);
    if (!view) return view.error();
    from.view = *std::move(view);
    due_ = due_ || !(from == drawn_from_) || !(remedies_ == request.remedies);
    drawn_from_ = std::move(from);
    remedies_ = request.remedies;
    return {};
}

engine::Result<void> CasterTexture::draw_samples(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const render::Geometry& geometry,
    const gpu::Framebuffer& target,
    const std::vector<Placed>& what,
    const std::string& fragment) const {
    std::vector<const render::DrawItem*> items;
    for (const render::DrawItem& item : geometry.items)
        if (std::any_of(what.begin(), what.end(), [&](const Placed& placed) {
                return placed.entity == item.entity.value;
            }))
            items.push_back(&item);
    const render::DrawList list = render::build_caster_list(
        items,
        geometry.world.assets,
        geometry.pool,
        origin_,
        is_local(light_) ? std::optional(light_.position) : std::nullopt);
    render::DrawRuns draws("shadow_texture/" + light_.name, geometry.pool);
    draws.upload(list);
    const glm::dmat4 from_origin = glm::translate(glm::dmat4(1.0), origin_);
    const glm::mat4 clip_from_relative(
        clip_from_map() * map_from_world(drawn_from_.view) * from_origin);
    const gpu::ScopedPass pass(
        frame, fmt::format("{}/shadow_texture/render", light_.name), target, {.depth = 0.0F});
    frame.counters().map_texels += pixels(target.whole());
    return draw_depth(
        frame,
        shaders,
        geometry.textures,
        draws,
        list,
        clip_from_relative,
        {.holes = remedies_.on(Remedy::caster_holes), .fragment = fragment});
}

engine::Result<void> CasterTexture::reduce(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const gpu::Texture& casters,
    const gpu::Texture* catchers) {
    const int size = drawn_from_.size;
    if (!texture_ || texture_.width() != size) {
        const std::string label = fmt::format("{}/shadow_texture", light_.name);
        texture_ =
            gpu::Texture(label, {.format = gpu::Format::rgba32f, .width = size, .height = size});
        auto target = gpu::Framebuffer::make(label, {.colors = {gpu::Attachment{&texture_}}});
        if (!target) return target.error();
        target_ = *std::move(target);
    }
    gpu::Defines defines;
    if (catchers != nullptr) defines.emplace_back("CAUGHT");
    const auto program =
        shaders.graphics("gpu/fullscreen.vert", "shadows/texture_reduce.frag", defines);
    if (!program) return program.error();
    const gpu::ScopedPass pass(
        frame, fmt::format("{}/shadow_texture/reduce", light_.name), target_);
    frame.state(gpu::kScreenState);
    casters.bind(UNIT_DEPTH);
    if (catchers != nullptr) catchers->bind(UNIT_VISIBILITY);
    frame.draw_fullscreen(**program);
    frame.counters().map_texels += pixels(target_.whole());
    return {};
}

engine::Result<void> CasterTexture::render(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const render::Geometry& geometry,
    TextureSamples& samples) {
    if (!due_) return {};
    const int fine = drawn_from_.size * kSamplesPerSide;
    const auto casters = samples.get(fine, 0);
    if (!casters) return casters.error();
    if (auto drawn = draw_samples(
            frame,
            shaders,
            geometry,
            (*casters)->target,
            drawn_from_.casters,
            "shadows/map_depth.frag");
        !drawn)
        return drawn;
    const gpu::Texture* caught = nullptr;
    if (!drawn_from_.catchers.empty()) {
        const auto catchers = samples.get(fine, 1);
        if (!catchers) return catchers.error();
        (*casters)->depth.bind(UNIT_DEPTH);
        if (auto drawn = draw_samples(
                frame,
                shaders,
                geometry,
                (*catchers)->target,
                drawn_from_.catchers,
                "shadows/texture_catch.frag");
            !drawn)
            return drawn;
        caught = &(*catchers)->depth;
    }
    if (auto reduced = reduce(frame, shaders, (*casters)->depth, caught); !reduced) return reduced;
    due_ = false;
    return {};
}

gpu::Defines CasterTexture::mask_defines() const {
    gpu::Defines defines = {is_local(light_) ? "SPOT" : "PARALLEL", "MAP_LAYERS=1"};
    if (!remedies_.on(Remedy::texture_behind_only)) defines.emplace_back("ANYWHERE");
    if (!remedies_.on(Remedy::texture_before_light)) defines.emplace_back("BACKWARD");
    if (!remedies_.on(Remedy::texture_border)) defines.emplace_back("CLAMPED");
    if (!remedies_.on(Remedy::texture_half_coverage)) defines.emplace_back("BLOCKS");
    if (!remedies_.on(Remedy::texture_plane_depth)) defines.emplace_back("ONE_DEPTH");
    return defines;
}

void CasterTexture::look_up(
    gpu::Frame& frame,
    const gpu::Program& mask,
    const scene::CameraView& camera,
    std::span<const gpu::Rect> areas,
    gpu::RenderState state) const {
    if (const auto* parallel = std::get_if<ParallelView>(&drawn_from_.view))
        set_view(mask, *parallel, camera, 0);
    else
        set_view(mask, std::get<PyramidView>(drawn_from_.view), camera);
    texture_.bind(UNIT_VISIBILITY);
    for (const gpu::Rect& area : areas) {
        state.scissor = area;
        frame.state(state);
        frame.draw_fullscreen(mask);
        frame.counters().mask_fragments += pixels(area);
        frame.counters().taps += 4 * pixels(area);
    }
}

} // namespace shadows
