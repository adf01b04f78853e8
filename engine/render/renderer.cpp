#include "engine/render/renderer.hpp"

#include "engine/core/check.hpp"
#include "engine/gpu/pass.hpp"
#include "engine/gpu/readback.hpp"

#include <embedded/render_shaders.hpp>
#include <fmt/format.h>
#include <render/shared/frame.h>
#include <render/shared/lights.h>

namespace render {

namespace {

std::vector<gpu::ShaderFolder> with_own(std::vector<gpu::ShaderFolder> folders) {
    folders.push_back(embedded::render_shaders());
    return folders;
}

FrameConstants constants_of(const scene::CameraView& camera) {
    // Window coordinates count from the bottom; CameraView counts from the top.
    const glm::dvec3 corner = camera.ray_direction(0.0, camera.height);
    FrameConstants constants;
    constants.clip_from_relative = camera.clip_from_relative();
    constants.ray_corner = glm::vec4(glm::vec3(corner), 0.0F);
    constants.ray_per_x =
        glm::vec4(glm::vec3(camera.ray_direction(1.0, camera.height) - corner), 0.0F);
    constants.ray_per_y =
        glm::vec4(glm::vec3(camera.ray_direction(0.0, camera.height - 1.0) - corner), 0.0F);
    constants.size_near = glm::vec4(
        static_cast<float>(camera.width), static_cast<float>(camera.height), camera.near, 0.0F);
    return constants;
}

} // namespace

Renderer::Renderer(std::vector<gpu::ShaderFolder> shader_folders)
    : shaders_(with_own(std::move(shader_folders))),
      frame_constants_(gpu::Buffer::dynamic("frame/constants")),
      draws_("geometry", pool_) {}

engine::Result<void> Renderer::draw(
    const scene::World& world,
    const scene::CameraView& camera,
    std::span<const scene::PlacedLight> lights,
    LightVisibility* visibility,
    const gpu::Framebuffer& target,
    const FrameSettings& settings) {
    CHECK_EQ(target.width(), camera.width);
    CHECK_EQ(target.height(), camera.height);
    frame_.begin();
    const auto drawn = draw_frame(world, camera, lights, visibility, target, settings);
    frame_.end();
    return drawn;
}

engine::Result<void> Renderer::draw_frame(
    const scene::World& world,
    const scene::CameraView& camera,
    std::span<const scene::PlacedLight> lights,
    LightVisibility* visibility,
    const gpu::Framebuffer& target,
    const FrameSettings& settings) {
    {
        const gpu::ScopedPass pass(frame_, "gather");
        sync(world);
        upload_view(world, camera);
    }
    const FrameInput input{world, receivers_, camera, lights};
    if (visibility != nullptr) {
        const gpu::ScopedPass pass(frame_, "plan");
        if (auto prepared = visibility->prepare(input); !prepared) return prepared;
    }
    const bool with_stencil = visibility != nullptr && visibility->needs_stencil();
    if (auto sized = resize(camera.width, camera.height, with_stencil); !sized) return sized;
    if (auto drawn = draw_geometry(frame_, shaders_, *gbuffer_, textures_, draws_, list_); !drawn)
        return drawn;
    if (visibility != nullptr)
        if (auto refreshed =
                visibility->refresh(frame_, shaders_, {world, pool_, textures_, items_.all()});
            !refreshed)
            return refreshed;
    return light_frame(input, visibility, target, settings);
}

void Renderer::sync(const scene::World& world) {
    if (world.identity.number() != world_) {
        pool_.clear();
        textures_ = Textures();
        items_ = DrawItems();
        mesh_versions_ = 0;
        world_ = world.identity.number();
    }
    const std::uint64_t versions = world.registry.version<scene::MeshInstance>();
    if (versions != mesh_versions_) receivers_ = scene::ReceiverTable(world);
    mesh_versions_ = versions;
    textures_.sync(world.assets);
    pool_.sync(world);
    items_.sync(world, receivers_, pool_);
}

void Renderer::upload_view(const scene::World& world, const scene::CameraView& camera) {
    const FrameConstants constants = constants_of(camera);
    frame_constants_.assign(gpu::bytes_of_value(constants));
    frame_constants_.bind_uniform(FRAME_BINDING);
    const auto visible = visible_items(items_.all(), camera.position, constants.clip_from_relative);
    list_ = build_draw_list(visible, world.assets, pool_, camera.position);
    draws_.upload(list_);
}

engine::Result<void> Renderer::light_frame(
    const FrameInput& input,
    LightVisibility* visibility,
    const gpu::Framebuffer& target,
    const FrameSettings& settings) {
    std::vector<gpu::Rect> areas;
    std::vector<bool> masked;
    for (std::size_t light = 0; light < input.lights.size(); ++light) {
        areas.push_back(screen_rect(input.camera, input.lights[light]));
        masked.push_back(visibility != nullptr && visibility->serves(light));
    }
    const auto batches = batch_lights(input.lights, areas, masked);
    const Exposure exposure{
        input.world.ambient, settings.exposure.value_or(default_exposure(input.lights))};
    const gpu::Texture* earlier = nullptr;
    for (std::size_t index = 0; index < batches.size(); ++index) {
        const LightBatch& batch = batches[index];
        if (auto reserved = reserve_masks(batch.layer_count); !reserved) return reserved;
        if (visibility != nullptr) draw_masks(batch, *visibility);
        const bool last = index + 1 == batches.size();
        const auto into =
            last ? engine::Result<const gpu::Framebuffer*>(&target) : light_target(index);
        if (!into) return into.error();
        const Lighting::Pass pass{
            batch,
            input.camera,
            input.lights,
            exposure,
            batch.layer_count > 0 ? &masks_.texture : nullptr,
            earlier,
            last};
        if (auto lit = lighting_.draw(frame_, shaders_, *gbuffer_, **into, pass); !lit) return lit;
        earlier = &light_textures_[index % 2];
    }
    return {};
}

void Renderer::draw_masks(const LightBatch& batch, LightVisibility& visibility) {
    for (const BatchLight& entry : batch.lights) {
        if (!entry.layer) continue;
        const gpu::Framebuffer& mask = masks_.targets[static_cast<std::size_t>(*entry.layer)];
        gpu::clear_target(frame_, mask, {.color = glm::vec4(1.0F), .area = entry.area});
        visibility.apply(
            frame_, entry.light, mask_target(static_cast<std::size_t>(*entry.layer), entry.area));
    }
}

VisibilityTarget Renderer::mask_target(std::size_t layer, const gpu::Rect& area) const {
    return {
        masks_.targets[layer],
        masks_.with_stencil.empty() ? nullptr : &masks_.with_stencil[layer],
        gbuffer_->surface(),
        gbuffer_->facets(),
        gbuffer_->depth(),
        area};
}

engine::Result<engine::Image> Renderer::draw_mask(std::size_t light, LightVisibility& visibility) {
    if (auto reserved = reserve_masks(1); !reserved) return reserved.error();
    const gpu::Framebuffer& mask = masks_.targets.front();
    frame_.begin();
    gpu::clear_target(frame_, mask, {.color = glm::vec4(1.0F)});
    if (visibility.serves(light)) visibility.apply(frame_, light, mask_target(0, mask.whole()));
    frame_.end();
    return gpu::read_image(masks_.texture);
}

engine::Result<void> Renderer::resize(int width, int height, bool with_stencil) {
    // A stencil that is there already stays: it costs less than making it again and again.
    if (gbuffer_ && gbuffer_->target().width() == width && gbuffer_->target().height() == height
        && (!with_stencil || gpu::traits(gbuffer_->depth().format()).stencil))
        return {};
    auto made = GBuffer::make(width, height, with_stencil);
    if (!made) return made.error();
    gbuffer_ = *std::move(made);
    masks_ = {};
    light_targets_ = {};
    light_textures_ = {};
    return {};
}

engine::Result<void> Renderer::reserve_masks(int layers) {
    if (static_cast<std::size_t>(layers) <= masks_.targets.size()) return {};
    const gpu::Rect size = gbuffer_->target().whole();
    MaskLayers made;
    made.texture = gpu::Texture(
        "masks",
        {.kind = gpu::TextureKind::array,
         .format = gpu::Format::r8,
         .width = size.width,
         .height = size.height,
         .layers = layers});
    for (int layer = 0; layer < layers; ++layer) {
        auto target = gpu::Framebuffer::make(
            fmt::format("mask {}", layer), {.colors = {{&made.texture, 0, layer}}});
        if (!target) return target.error();
        made.targets.push_back(*std::move(target));
        if (!gpu::traits(gbuffer_->depth().format()).stencil) continue;
        auto with_stencil = gpu::Framebuffer::make(
            fmt::format("mask {} with stencil", layer),
            {.colors = {{&made.texture, 0, layer}}, .depth = gpu::Attachment{&gbuffer_->depth()}});
        if (!with_stencil) return with_stencil.error();
        made.with_stencil.push_back(*std::move(with_stencil));
    }
    masks_ = std::move(made);
    return {};
}

engine::Result<const gpu::Framebuffer*> Renderer::light_target(std::size_t batch) {
    gpu::Framebuffer& target = light_targets_[batch % 2];
    if (target.width() > 0) return &target;
    gpu::Texture& texture = light_textures_[batch % 2];
    const gpu::Rect size = gbuffer_->target().whole();
    texture = gpu::Texture(
        fmt::format("light {}", batch % 2),
        {.format = gpu::Format::rgba16f, .width = size.width, .height = size.height});
    auto made =
        gpu::Framebuffer::make(fmt::format("light {}", batch % 2), {.colors = {{&texture}}});
    if (!made) return made.error();
    target = *std::move(made);
    return &target;
}

} // namespace render
