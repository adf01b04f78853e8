#include "systems/shadows/techniques/planar_draws.hpp"

#include <render/shared/bindings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>

namespace shadows {

namespace {

/// Ten steps of a 24-bit depth buffer: what ends the fight between a shadow and its receiver when
/// there is no stencil.
constexpr float kDepthOffset = 10.0F / 16777216.0F;

/// The sides of a cube whose corner i has the signs of i's bits.
constexpr std::array<std::uint32_t, 36> kCube = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6,
                                                 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7,
                                                 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

} // namespace

glm::dmat4 clip_from_origin(const scene::CameraView& camera, const glm::dvec3& origin) {
    const glm::dmat4 view(glm::transpose(glm::dmat3(camera.world_from_view)));
    return glm::dmat4(camera.clip_from_view()) * view
           * glm::translate(glm::dmat4(1.0), origin - camera.position);
}

engine::Result<void>
PlanarDraws::fetch_programs(gpu::ShaderLibrary& shaders, const Remedies& remedies) {
    remedies_ = remedies;
    gpu::Defines defines;
    if (!remedies_.on(Remedy::planar_anti_shadow_clip)) defines.emplace_back("EARLY_DIVISION");
    const auto solid = shaders.graphics("shadows/planar.vert", "shadows/planar.frag", defines);
    if (!solid) return solid.error();
    defines.emplace_back("ALPHA_MASKED");
    const auto masked = shaders.graphics("shadows/planar.vert", "shadows/planar.frag", defines);
    if (!masked) return masked.error();
    solid_ = *solid;
    masked_ = *masked;
    return {};
}

void PlanarDraws::begin(
    const render::Geometry& geometry, const LightView& light, const glm::dvec3& origin) {
    light_ = light;
    origin_ = origin;
    textures_ = &geometry.textures;
    list_ = {};
    boxes_.clear();
    item_of_.clear();
    for (std::size_t i = 0; i < geometry.items.size(); ++i)
        item_of_[geometry.items[i].entity.value] = i;
}

PlanarDraws::Runs
PlanarDraws::append(const PlanarCasters& casters, const render::Geometry& geometry) {
    Runs runs;
    append_meshes(casters.entities, geometry, runs);
    runs.first_box = static_cast<std::uint32_t>(boxes_.size());
    for (const BoxedCaster& boxed : casters.boxed)
        for (const engine::Aabb& box :
             geometry.world.assets.meshes[boxed.mesh].box_sets[boxed.set].boxes) {
            const glm::dmat4 placed =
                glm::translate(boxed.world_from_mesh, glm::dvec3(box.centre()));
            boxes_.push_back(render::placed_instance(
                glm::scale(placed, glm::dvec3(box.extent()) * 0.5), origin_));
        }
    runs.box_count = static_cast<std::uint32_t>(boxes_.size()) - runs.first_box;
    return runs;
}

void PlanarDraws::append_meshes(
    std::span<const std::uint32_t> entities, const render::Geometry& geometry, Runs& runs) {
    std::vector<std::size_t> indices;
    for (const std::uint32_t entity : entities)
        indices.push_back(item_of_.at(entity));
    std::sort(indices.begin(), indices.end()); // equal neighbours become one draw
    std::vector<const render::DrawItem*> items;
    for (const std::size_t index : indices)
        items.push_back(&geometry.items[index]);
    const bool sun = light_.light.kind == scene::LightKind::directional;
    render::DrawList part = render::build_caster_list(
        items,
        geometry.world.assets,
        geometry.pool,
        origin_,
        sun ? std::nullopt : std::optional(light_.position));
    runs.first = list_.runs.size();
    runs.count = part.runs.size();
    for (render::DrawList::Run& run : part.runs)
        run.first_command += static_cast<std::uint32_t>(list_.commands.size());
    for (render::DrawCommand& command : part.commands)
        command.first_instance += static_cast<std::uint32_t>(list_.instances.size());
    std::move(part.runs.begin(), part.runs.end(), std::back_inserter(list_.runs));
    std::move(part.commands.begin(), part.commands.end(), std::back_inserter(list_.commands));
    std::move(part.instances.begin(), part.instances.end(), std::back_inserter(list_.instances));
}

void PlanarDraws::make_cube() {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    const std::string label = "planar/" + light_.name + "/cube";
    cube_corners_ = gpu::Buffer::fixed(label, gpu::bytes_of(corners));
    cube_indices_ = gpu::Buffer::fixed(
        label + "/indices", std::as_bytes(std::span<const std::uint32_t>(kCube)));
    box_instances_ = gpu::Buffer::dynamic(label + "/instances");
    using gpu::Component;
    const std::vector<gpu::VertexStream> streams = {
        {&cube_corners_, sizeof(glm::vec3), {{ATTRIBUTE_POSITION, 3, Component::f32, 0}}},
        {&box_instances_,
         sizeof(render::InstanceData),
         {{ATTRIBUTE_ROW_0, 4, Component::f32, offsetof(render::InstanceData, row_0)},
          {ATTRIBUTE_ROW_1, 4, Component::f32, offsetof(render::InstanceData, row_1)},
          {ATTRIBUTE_ROW_2, 4, Component::f32, offsetof(render::InstanceData, row_2)}},
         true}};
    cube_ = gpu::VertexArray(label, streams, &cube_indices_);
}

void PlanarDraws::upload(const render::Geometry& geometry) {
    if (!draws_) draws_.emplace("planar/" + light_.name, geometry.pool);
    draws_->upload(list_);
    if (boxes_.empty()) return;
    if (cube_.name() == 0) make_cube();
    box_instances_.assign(gpu::bytes_of(boxes_));
}

void PlanarDraws::draw(
    gpu::Frame& frame, const PlanarView& view, const Runs& runs, gpu::RenderState state) const {
    for (const gpu::Program* program : {solid_, masked_})
        set_view(*program, view);
    for (std::size_t i = 0; i < runs.count; ++i) {
        const render::DrawList::Run& run = list_.runs[runs.first + i];
        state.cull = run.bucket.double_sided ? gpu::Cull::none : gpu::Cull::back;
        state.front_face =
            run.bucket.mirrored ? gpu::FrontFace::clockwise : gpu::FrontFace::counter_clockwise;
        frame.state(state);
        if (run.bucket.alpha_masked) textures_->get(run.bucket.texture).bind(UNIT_BASE_COLOR);
        draws_->draw(frame, run.bucket.alpha_masked ? *masked_ : *solid_, run);
    }
    if (runs.box_count == 0) return;
    state.cull = gpu::Cull::none; // a box may be mirrored, and is small
    frame.state(state);
    frame.draw(
        *solid_,
        cube_,
        {.count = static_cast<std::uint32_t>(kCube.size()),
         .instances = runs.box_count,
         .base_instance = runs.first_box});
}

std::size_t PlanarDraws::gpu_bytes() const {
    return list_.instances.size() * sizeof(render::InstanceData)
           + list_.commands.size() * sizeof(render::DrawCommand) + box_instances_.size_bytes();
}

void PlanarDraws::set_view(const gpu::Program& program, const PlanarView& view) const {
    const LitPlane& plane = view.sample.plane;
    const glm::dmat4 clip_from_caster =
        view.clip_from_origin * shadow_from_caster(view.sample.light, plane, origin_);
    program.set("clip_from_caster", glm::mat4(clip_from_caster));
    const double height_of_origin = glm::dot(plane.normal, origin_) - plane.offset;
    program.set(
        "height_plane", glm::vec4(glm::vec3(plane.normal), static_cast<float>(height_of_origin)));
    program.set("height_range", height_range(plane));
    program.set("per_light_height", static_cast<float>(1.0 / plane.light_height));
    program.set("depth_offset", remedies_.on(Remedy::planar_no_offset) ? 0.0F : kDepthOffset);
    program.set("value", view.value);
}

glm::vec2 PlanarDraws::height_range(const LitPlane& plane) const {
    constexpr float kFar = std::numeric_limits<float>::max() * 0.25F;
    glm::vec2 range(
        static_cast<float>(plane.least_height),
        static_cast<float>(std::min(plane.most_height(), static_cast<double>(kFar))));
    if (!remedies_.on(Remedy::planar_behind_clip)) range.x = -kFar;
    if (!remedies_.on(Remedy::planar_anti_shadow_clip)) range.y = kFar;
    return range;
}

} // namespace shadows
