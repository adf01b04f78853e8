#include "engine/render/lighting.hpp"

#include "engine/gpu/pass.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <render/shared/lights.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

namespace {

/// Pixels that show nothing: a dull sky, linear.
constexpr glm::vec3 kBackground = {0.18F, 0.24F, 0.33F};

gpu::VertexArray make_vertices(const gpu::Buffer& tiles) {
    using gpu::Component;
    const std::vector<gpu::VertexStream> streams = {
        {&tiles,
         sizeof(LightTile),
         {{0, 4, Component::u32, offsetof(LightTile, rectangle)},
          {1, 1, Component::u32, offsetof(LightTile, bits)}},
         true}};
    return {"lighting/tiles", streams};
}

float kind_of(scene::LightKind kind) {
    switch (kind) {
    case scene::LightKind::spot:
        return LIGHT_SPOT;
    case scene::LightKind::point:
        return LIGHT_POINT;
    case scene::LightKind::directional:
        break;
    }
    return LIGHT_DIRECTIONAL;
}

/// Fall-off of the cone as KHR_lights_punctual writes it: clamp(cos * scale + offset)^2. Points
/// shine everywhere.
glm::vec4 cone_of(const scene::Light& light) {
    if (light.kind != scene::LightKind::spot) return {0.0F, 1.0F, 0.0F, 0.0F};
    const float cos_outer = std::cos(light.outer_angle);
    const float scale = 1.0F / std::max(0.001F, std::cos(light.inner_angle) - cos_outer);
    return {scale, -cos_outer * scale, 0.0F, 0.0F};
}

LightData data_of(const BatchLight& entry, const Lighting::Pass& pass) {
    const scene::PlacedLight& placed = pass.lights[entry.light];
    const scene::Light& light = placed.light;
    const glm::vec3 relative(placed.position - pass.camera.position);
    const float range_2 = light.range * light.range;
    const float strength =
        light.intensity * pass.exposure.scale * static_cast<float>(std::numbers::inv_pi);
    LightData data;
    data.position_kind = glm::vec4(relative, kind_of(light.kind));
    data.direction_layer =
        glm::vec4(placed.direction, entry.layer ? static_cast<float>(*entry.layer) : NO_MASK_LAYER);
    data.color_range = glm::vec4(light.color * strength, 1.0F / (range_2 * range_2));
    data.cone = cone_of(light);
    return data;
}

LightConstants constants_of(const Lighting::Pass& pass) {
    LightConstants constants = {};
    if (pass.earlier == nullptr) {
        constants.ambient = glm::vec4(pass.exposure.ambient, 0.0F);
        constants.background = glm::vec4(kBackground, 0.0F);
    }
    for (std::size_t i = 0; i < pass.batch.lights.size(); ++i)
        constants.lights[i] = data_of(pass.batch.lights[i], pass);
    return constants;
}

gpu::Defines defines_of(const Lighting::Pass& pass) {
    const auto is_directional = [&](const BatchLight& entry) {
        return pass.lights[entry.light].light.kind == scene::LightKind::directional;
    };
    const auto& lights = pass.batch.lights;
    const auto directional = std::count_if(lights.begin(), lights.end(), is_directional);
    const auto local = static_cast<std::ptrdiff_t>(lights.size()) - directional;
    // More than two local lights are a loop over bits: one program serves any number of them.
    gpu::Defines defines = {
        fmt::format("DIRECTIONAL_COUNT={}", directional),
        fmt::format("LOCAL_COUNT={}", std::min<std::ptrdiff_t>(local, 3))};
    const bool spots = std::any_of(lights.begin(), lights.end(), [&](const BatchLight& entry) {
        return pass.lights[entry.light].light.kind == scene::LightKind::spot;
    });
    if (spots) defines.emplace_back("SPOTS");
    if (pass.masks != nullptr) defines.emplace_back("MASKS");
    if (pass.earlier != nullptr) defines.emplace_back("ADD_EARLIER");
    if (pass.last) defines.emplace_back("TONE_MAP");
    return defines;
}

} // namespace

float default_exposure(std::span<const scene::PlacedLight> lights) {
    constexpr float kWhite = 0.8F;
    constexpr float kWorkingDistance = 3.0F;
    float strongest = 0.0F;
    for (const scene::PlacedLight& placed : lights) {
        const scene::Light& light = placed.light;
        float illuminance = light.intensity;
        if (light.kind != scene::LightKind::directional) {
            const float distance =
                std::isfinite(light.range) ? light.range * 0.25F : kWorkingDistance;
            illuminance /= std::max(distance * distance, 1e-4F);
        }
        strongest = std::max(
            strongest, illuminance * std::max({light.color.r, light.color.g, light.color.b}));
    }
    return strongest > 0.0F ? kWhite * static_cast<float>(std::numbers::pi) / strongest : 1.0F;
}

Lighting::Lighting()
    : constants_(gpu::Buffer::dynamic("lighting/constants")),
      tiles_(gpu::Buffer::dynamic("lighting/tiles")),
      vertices_(make_vertices(tiles_)) {}

engine::Result<void> Lighting::draw(
    gpu::Frame& frame,
    gpu::ShaderLibrary& shaders,
    const GBuffer& gbuffer,
    const gpu::Framebuffer& target,
    const Pass& pass) {
    const auto program =
        shaders.graphics("render/lighting.vert", "render/lighting.frag", defines_of(pass));
    if (!program) return program.error();
    const auto tiles = light_tiles(pass.batch, pass.camera.width, pass.camera.height);
    tiles_.assign(gpu::bytes_of(tiles));
    const LightConstants constants = constants_of(pass);
    constants_.assign(gpu::bytes_of_value(constants));

    const gpu::ScopedPass scope(frame, "lighting", target);
    frame.state(gpu::kScreenState);
    constants_.bind_uniform(LIGHTS_BINDING);
    gbuffer.surface().bind(UNIT_GBUFFER);
    gbuffer.depth().bind(UNIT_DEPTH);
    if (pass.masks != nullptr) pass.masks->bind(UNIT_MASKS);
    if (pass.earlier != nullptr) pass.earlier->bind(UNIT_LIGHT);
    gpu::DrawRange range;
    range.count = 4;
    range.instances = static_cast<std::uint32_t>(tiles.size());
    range.primitive = gpu::Primitive::triangle_strip;
    frame.draw(**program, vertices_, range);
    return {};
}

} // namespace render
