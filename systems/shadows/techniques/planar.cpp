// Casters projected on flat receivers: the right choice for floors and walls, where its edges are
// exact for hard lights at any size on screen and any distance from the light. It costs the
// casters' triangles once per receiver. Its artefacts: edges are hard even where the light is
// large, and a receiver that is not quite flat shows the shadow where its plane would.
//
// The stencil holds the pixels of one receiver at a time, so that nothing can hang in the air,
// fight with the receiver's depth or paint over what lies on it; each pixel is darkened once, and
// loses its mark by it.

#include "engine/gpu/pass.hpp"
#include "engine/render/draw_runs.hpp"
#include "engine/render/light_visibility.hpp"
#include "systems/shadows/planar_casters.hpp"
#include "systems/shadows/planar_prediction.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/rectangles.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <unordered_map>

namespace shadows {

namespace {

/// Marks that tell receivers apart until the stencil is wiped.
constexpr std::uint8_t kLastMark = 127;
/// Ten steps of a 24-bit depth buffer: what ends the fight between a shadow and its receiver when
/// there is no stencil.
constexpr float kDepthOffset = 10.0F / 16777216.0F;

/// A position relative to `origin` into clip space, in doubles until the last step.
glm::dmat4 clip_from_origin(const scene::CameraView& camera, const glm::dvec3& origin) {
    const glm::dmat4 view(glm::transpose(glm::dmat3(camera.world_from_view)));
    return glm::dmat4(camera.clip_from_view()) * view
           * glm::translate(glm::dmat4(1.0), origin - camera.position);
}

/// What one receiver needs of its casters, and where they are in the job's draw list.
struct Serving {
    PlanarCasters casters;
    std::size_t first_run = 0;
    std::size_t run_count = 0;
};

class PlanarJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_ = request.scene.lights[request.light];
        remedies_ = request.remedies;
        origin_ = request.scene.camera.position;
        servings_.clear();
        for (const Plan* plan : request.plans)
            serve(request, *plan);
        return {};
    }

    engine::Result<void> render(
        gpu::Frame& /*frame*/,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry) override {
        if (auto fetched = fetch_programs(shaders); !fetched) return fetched;
        textures_ = &geometry.textures;
        list_ = {};
        std::unordered_map<std::uint32_t, std::size_t> item_of;
        for (std::size_t i = 0; i < geometry.items.size(); ++i)
            item_of[geometry.items[i].entity.value] = i;
        for (Serving& serving : servings_)
            append_casters(serving, geometry, item_of);
        if (!draws_) draws_.emplace("planar/" + light_.name, geometry.pool);
        draws_->upload(list_);
        return {};
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        const gpu::ScopedPass pass(
            frame, fmt::format("planar/{}", light_.name), *target.mask_with_stencil);
        gpu::Rect marked;
        std::uint8_t mark = 0;
        for (const Serving& serving : servings_) {
            if (serving.casters.plane.height(camera.position) <= 0.0) continue;
            const gpu::Rect area =
                intersection(to_rect(screen_bounds(camera, serving.casters.bounds)), target.area);
            if (area.empty()) continue;
            if (mark == kLastMark) {
                wipe(frame, target, marked);
                mark = 0;
            }
            ++mark;
            marked = hull(marked, area);
            if (tagged()) mark_receiver(frame, target, serving, area, mark);
            draw_casters(frame, camera, serving, tagged() ? area : target.area, mark);
        }
        wipe(frame, target, marked);
    }

    [[nodiscard]] bool needs_stencil() const override { return true; }

    [[nodiscard]] std::size_t gpu_bytes() const override {
        return list_.instances.size() * sizeof(render::InstanceData)
               + list_.commands.size() * sizeof(render::DrawCommand);
    }

private:
    void serve(const ShadowRequest& request, const Plan& plan) {
        const ReceiverView& receiver = request.scene.receiver(plan.receiver);
        for (const PlanEntry& entry : plan.entries) {
            if (entry.technique != "planar") continue;
            auto casters = planar_casters(
                request.scene,
                light_,
                receiver,
                request.groups,
                entry.caster_groups,
                origin_,
                remedies_);
            if (casters) servings_.push_back({*std::move(casters)});
        }
    }

    [[nodiscard]] bool tagged() const {
        return remedies_.on(Remedy::planar_stencil) && remedies_.on(Remedy::planar_no_offset);
    }

    engine::Result<void> fetch_programs(gpu::ShaderLibrary& shaders) {
        const auto mark = shaders.graphics("gpu/fullscreen.vert", "shadows/planar_mark.frag");
        if (!mark) return mark.error();
        gpu::Defines defines;
        if (!remedies_.on(Remedy::planar_anti_shadow_clip)) defines.emplace_back("EARLY_DIVISION");
        const auto solid = shaders.graphics("shadows/planar.vert", "shadows/planar.frag", defines);
        if (!solid) return solid.error();
        defines.emplace_back("ALPHA_MASKED");
        const auto masked = shaders.graphics("shadows/planar.vert", "shadows/planar.frag", defines);
        if (!masked) return masked.error();
        mark_ = *mark;
        solid_ = *solid;
        masked_ = *masked;
        return {};
    }

    /// Casters of several receivers in one list, each receiver a row of runs.
    void append_casters(
        Serving& serving,
        const render::Geometry& geometry,
        const std::unordered_map<std::uint32_t, std::size_t>& item_of) {
        std::vector<std::size_t> indices;
        for (const std::uint32_t entity : serving.casters.entities)
            indices.push_back(item_of.at(entity));
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
        serving.first_run = list_.runs.size();
        serving.run_count = part.runs.size();
        for (render::DrawList::Run& run : part.runs)
            run.first_command += static_cast<std::uint32_t>(list_.commands.size());
        for (render::DrawCommand& command : part.commands)
            command.first_instance += static_cast<std::uint32_t>(list_.instances.size());
        std::move(part.runs.begin(), part.runs.end(), std::back_inserter(list_.runs));
        std::move(part.commands.begin(), part.commands.end(), std::back_inserter(list_.commands));
        std::move(
            part.instances.begin(), part.instances.end(), std::back_inserter(list_.instances));
    }

    /// Writes `mark` where the receiver is seen.
    void mark_receiver(
        gpu::Frame& frame,
        const render::VisibilityTarget& target,
        const Serving& serving,
        const gpu::Rect& area,
        std::uint8_t mark) {
        gpu::RenderState state = gpu::kScreenState;
        state.color_write = gpu::kWriteNoColor;
        state.scissor = area;
        state.stencil = gpu::Stencil::both(
            {.test = gpu::Compare::greater_equal,
             .on_pass = gpu::StencilOp::replace,
             .reference = mark});
        frame.state(state);
        target.gbuffer.bind(UNIT_GBUFFER);
        mark_->set("receiver", serving.casters.receiver);
        frame.draw_fullscreen(*mark_);
        frame.counters().stencil_fragments += pixels(area);
        frame.counters().taps += pixels(area);
    }

    [[nodiscard]] gpu::RenderState shading_state(const gpu::Rect& area, std::uint8_t mark) const {
        gpu::RenderState state;
        state.depth_write = false;
        state.depth_test = tagged() ? gpu::Compare::always : gpu::Compare::greater_equal;
        state.scissor = area;
        state.clip_distances = 2;
        if (!tagged()) return state;
        // A pixel that is dark already loses its mark; marks that stay are higher than all others.
        const bool fresh = remedies_.on(Remedy::planar_fresh_stencil);
        state.stencil = gpu::Stencil::both(
            {.test = gpu::Compare::equal,
             .on_pass = fresh ? gpu::StencilOp::zero : gpu::StencilOp::invert,
             .reference = mark});
        return state;
    }

    void draw_casters(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const Serving& serving,
        const gpu::Rect& area,
        std::uint8_t mark) {
        const LitPlane& plane = serving.casters.plane;
        const glm::mat4 clip_from_caster(
            clip_from_origin(camera, origin_) * shadow_from_caster(light_, plane, origin_));
        const glm::vec4 heights(
            glm::vec3(plane.normal),
            static_cast<float>(glm::dot(plane.normal, origin_) - plane.offset));
        for (const gpu::Program* program : {solid_, masked_}) {
            program->set("clip_from_caster", clip_from_caster);
            program->set("height_plane", heights);
            program->set("height_range", height_range(plane));
            program->set("per_light_height", static_cast<float>(1.0 / plane.light_height));
            program->set(
                "depth_offset", remedies_.on(Remedy::planar_no_offset) ? 0.0F : kDepthOffset);
        }
        gpu::RenderState state = shading_state(area, mark);
        for (std::size_t i = 0; i < serving.run_count; ++i) {
            const render::DrawList::Run& run = list_.runs[serving.first_run + i];
            state.cull = run.bucket.double_sided ? gpu::Cull::none : gpu::Cull::back;
            state.front_face =
                run.bucket.mirrored ? gpu::FrontFace::clockwise : gpu::FrontFace::counter_clockwise;
            frame.state(state);
            if (run.bucket.alpha_masked) textures_->get(run.bucket.texture).bind(UNIT_BASE_COLOR);
            draws_->draw(frame, run.bucket.alpha_masked ? *masked_ : *solid_, run);
        }
        frame.counters().mask_fragments += pixels(area);
    }

    /// What of the casters is drawn, by height over the plane.
    [[nodiscard]] glm::vec2 height_range(const LitPlane& plane) const {
        constexpr float kFar = std::numeric_limits<float>::max() * 0.25F;
        glm::vec2 range(
            static_cast<float>(plane.least_height),
            static_cast<float>(std::min(plane.most_height(), static_cast<double>(kFar))));
        if (!remedies_.on(Remedy::planar_behind_clip)) range.x = -kFar;
        if (!remedies_.on(Remedy::planar_anti_shadow_clip)) range.y = kFar;
        return range;
    }

    /// Leaves the stencil as it was found.
    void
    wipe(gpu::Frame& frame, const render::VisibilityTarget& target, const gpu::Rect& marked) const {
        if (marked.empty() || !tagged() || !remedies_.on(Remedy::planar_fresh_stencil)) return;
        gpu::clear_target(frame, *target.mask_with_stencil, {.stencil = 0, .area = marked});
        frame.counters().stencil_fragments += pixels(marked);
    }

    LightView light_;
    Remedies remedies_;
    glm::dvec3 origin_ = {}; ///< of the instances' positions
    std::vector<Serving> servings_;
    render::DrawList list_;
    std::optional<render::DrawRuns> draws_;
    const render::Textures* textures_ = nullptr;
    const gpu::Program* mark_ = nullptr;
    const gpu::Program* solid_ = nullptr;
    const gpu::Program* masked_ = nullptr;
};

class Planar final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "planar", "casters projected on flat receivers, held to them by the stencil"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        return predict_planar(pair, casters);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<PlanarJob>();
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_planar() {
    return std::make_unique<Planar>();
}

} // namespace shadows
