// Stencil shadow volumes: the right choice for heroes, near and in motion, whose hard edges have to
// be exact to the pixel on whatever they fall, themselves included. Its artefacts: edges are hard
// even where the light is large. It costs a facing test per triangle of the caster whenever caster
// or light has moved, and the volume's pixels in every frame.
//
// A volume is drawn once, with its front faces counting against its back faces: before what is seen
// where the near plane is clear of it (z-pass), else behind it (z-fail). Both leave the number of
// volumes that hold a pixel. Depth is reversed and infinite, so what lies at infinity has a depth
// of exactly 0 and is never clipped: no depth clamp and no offset is needed to close a volume
// there.
//
// Source: T. Heidmann, "Real Shadows, Real Time", 1991; C. Everitt and M. Kilgard, "Practical and
// Robust Stenciled Shadow Volumes for Hardware-Accelerated Rendering", 2002; M. McGuire, "Efficient
// Shadow Volume Rendering", GPU Gems, 2004.

#include "engine/gpu/pass.hpp"
#include "engine/render/light_visibility.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/receiver_bits.hpp"
#include "systems/shadows/techniques/rectangles.hpp"
#include "systems/shadows/volumes/near_clip.hpp"
#include "systems/shadows/volumes/start_count.hpp"
#include "systems/shadows/volumes/volume_casters.hpp"
#include "systems/shadows/volumes/volume_prediction.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/receivers.h>

#include <map>

namespace shadows {

namespace {

class VolumeJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        light_ = request.scene.lights[request.light];
        remedies_ = request.remedies;
        casters_.update(request);
        bits_.resize(casters_.passes().size());
        for (std::size_t pass = 0; pass < bits_.size(); ++pass)
            bits_[pass].assign(casters_.passes()[pass], request.receiver_end);
        return {};
    }

    engine::Result<void> render(
        gpu::Frame& /*frame*/,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry) override {
        if (auto fetched = fetch_programs(shaders); !fetched) return fetched;
        if (!vertices_.name()) make_buffers();
        positions_ = &geometry.pool.positions();
        std::map<std::uint32_t, std::int32_t> base_vertex_of;
        for (const render::DrawItem& item : geometry.items)
            base_vertex_of[item.entity.value] = item.base_vertex;
        base_vertices_.clear();
        for (const VolumeCaster& caster : casters_.all())
            base_vertices_.push_back(base_vertex_of.at(caster.entity));
        if (casters_.take_changed()) indices_.assign(gpu::bytes_of(casters_.indices()));
        return {};
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        const gpu::ScopedPass pass(
            frame, fmt::format("volume/{}", light_.name), *target.mask_with_stencil);
        std::vector<render::InstanceData> instances;
        for (const VolumeCaster& caster : casters_.all())
            instances.push_back(render::placed_instance(caster.world_from_mesh, camera.position));
        instances_.assign(gpu::bytes_of(instances));
        positions_->bind_storage(VOLUME_POSITIONS_BINDING);
        target.gbuffer.bind(UNIT_GBUFFER);
        if (!remedies_.on(Remedy::volume_mesh_space))
            count_->set("eye", glm::vec3(camera.position));
        Batch batch;
        for (std::size_t i = 0; i < casters_.all().size(); ++i) {
            const VolumeCaster& caster = casters_.all()[i];
            const gpu::Rect area =
                remedies_.on(Remedy::volume_scissor)
                    ? intersection(to_rect(swept_pixels(camera, caster.reaches)), target.area)
                    : target.area;
            if (area.empty()) continue;
            const Counting how = counting_of(camera, caster);
            const bool full =
                batch.layers + caster.layers > kMostLayers && remedies_.on(Remedy::volume_batches);
            if (full || caster.pass != batch.pass || how.start != batch.start || how.start > 0) {
                darken(frame, batch);
                batch = {{}, 0, caster.pass, how.start};
            }
            batch.layers += caster.layers;
            batch.area = hull(batch.area, area);
            count(frame, caster, static_cast<std::uint32_t>(i), how.z_fail, area);
        }
        darken(frame, batch);
    }

    [[nodiscard]] bool needs_stencil() const override { return true; }

    [[nodiscard]] std::size_t gpu_bytes() const override {
        return indices_.capacity_bytes() + instances_.capacity_bytes();
    }

private:
    /// What is counted before the mask is lowered.
    struct Batch {
        gpu::Rect area;
        int layers = 0;
        std::size_t pass = 0;
        int start = 0; ///< what a count of 0 stands for
    };
    struct Counting {
        bool z_fail = false;
        int start = 0; ///< of z-pass: volumes that hold the near rectangle
    };

    [[nodiscard]] Counting
    counting_of(const scene::CameraView& camera, const VolumeCaster& caster) const {
        if (!remedies_.on(Remedy::volume_z_pass)) return {true, 0};
        if (!remedies_.on(Remedy::volume_z_fail)
            || !may_shade_near_plane(camera, light_, caster.bounds))
            return {};
        if (!remedies_.on(Remedy::volume_start_count)) return {true, 0};
        const auto start = start_count(
            camera,
            *caster.volume,
            *caster.positions,
            caster.world_from_mesh,
            caster.light_mesh,
            caster.bounds);
        return start ? Counting{false, *start} : Counting{true, 0};
    }

    engine::Result<void> fetch_programs(gpu::ShaderLibrary& shaders) {
        gpu::Defines defines;
        if (!remedies_.on(Remedy::volume_infinite)) defines.emplace_back("FINITE");
        if (!remedies_.on(Remedy::volume_no_far_plane)) defines.emplace_back("FAR_PLANE");
        if (!remedies_.on(Remedy::volume_mesh_space)) defines.emplace_back("WORLD_SPACE");
        const auto count =
            shaders.graphics("shadows/volume.vert", "shadows/volume_count.frag", defines);
        if (!count) return count.error();
        const auto mask = shaders.graphics("gpu/fullscreen.vert", "shadows/volume_mask.frag");
        if (!mask) return mask.error();
        count_ = *count;
        mask_ = *mask;
        return {};
    }

    void make_buffers() {
        const std::string label = "volume/" + light_.name;
        indices_ = gpu::Buffer::dynamic(label + "/indices");
        instances_ = gpu::Buffer::dynamic(label + "/instances");
        using gpu::Component;
        const std::vector<gpu::VertexStream> streams = {
            {&instances_,
             sizeof(render::InstanceData),
             {{ATTRIBUTE_ROW_0, 4, Component::f32, offsetof(render::InstanceData, row_0)},
              {ATTRIBUTE_ROW_1, 4, Component::f32, offsetof(render::InstanceData, row_1)},
              {ATTRIBUTE_ROW_2, 4, Component::f32, offsetof(render::InstanceData, row_2)}},
             true}};
        vertices_ = gpu::VertexArray(label, streams, &indices_);
    }

    [[nodiscard]] gpu::RenderState counting_state(bool z_fail, const gpu::Rect& area) const {
        const bool wraps = remedies_.on(Remedy::volume_wrap);
        const auto up = wraps ? gpu::StencilOp::increment_wrap : gpu::StencilOp::increment_clamp;
        const auto down = wraps ? gpu::StencilOp::decrement_wrap : gpu::StencilOp::decrement_clamp;
        gpu::RenderState state;
        // What lies at the depth of a surface counts as behind it: the lit cap is the lit surface.
        state.depth_test = remedies_.on(Remedy::volume_equal_depth) ? gpu::Compare::greater
                                                                    : gpu::Compare::greater_equal;
        state.depth_write = false;
        state.depth_clamp = false;
        state.clip_distances = remedies_.on(Remedy::volume_no_far_plane) ? 0 : 1;
        state.cull = gpu::Cull::none;
        state.color_write = gpu::kWriteNoColor;
        state.scissor = area;
        if (z_fail)
            state.stencil =
                gpu::Stencil{.front = {.on_depth_fail = down}, .back = {.on_depth_fail = up}};
        else
            state.stencil = gpu::Stencil{.front = {.on_pass = up}, .back = {.on_pass = down}};
        return state;
    }

    void count(
        gpu::Frame& frame,
        const VolumeCaster& caster,
        std::uint32_t instance,
        bool z_fail,
        const gpu::Rect& area) {
        const ShadowVolume& volume = *caster.volume;
        gpu::RenderState state = counting_state(z_fail, area);
        const auto draw = [&](std::uint32_t first, std::uint32_t end, bool mirrored) {
            if (first == end) return;
            state.front_face =
                mirrored ? gpu::FrontFace::clockwise : gpu::FrontFace::counter_clockwise;
            frame.state(state);
            gpu::DrawRange range;
            range.first = caster.first_index + first;
            range.count = end - first;
            range.base_vertex = 2 * base_vertices_[instance];
            range.base_instance = instance;
            frame.draw(*count_, vertices_, range);
        };
        count_->set("light_mesh", glm::vec4(caster.light_mesh));
        const auto end = static_cast<std::uint32_t>(volume.indices.size());
        if (!z_fail) {
            // The caps of a closed caster are its own surface: nothing is seen through them.
            draw(
                volume.far_end,
                caster.shows_through ? volume.near_end : volume.side_end,
                caster.mirrored);
            if (caster.shows_through) draw(volume.near_end, end, !caster.mirrored);
        } else if (caster.shows_through || !remedies_.on(Remedy::volume_equal_depth)) {
            draw(0, volume.near_end, caster.mirrored);
            draw(volume.near_end, end, !caster.mirrored);
        } else {
            // For the same reason they are behind whatever is seen, even where depths at the
            // caster's contour round to say otherwise.
            draw(0, volume.side_end, caster.mirrored);
            state.depth_test = gpu::Compare::never;
            draw(volume.side_end, volume.near_end, caster.mirrored);
        }
        frame.counters().stencil_fragments += pixels(area);
    }

    /// Lowers the mask where something was counted, and leaves the stencil as it was found.
    void darken(gpu::Frame& frame, const Batch& batch) {
        if (batch.area.empty()) return;
        bits_[batch.pass].bind();
        gpu::RenderState state = gpu::kScreenState;
        state.scissor = batch.area;
        state.blend = gpu::Blend::min;
        state.stencil = gpu::Stencil::both(
            {.test = gpu::Compare::not_equal,
             .on_stencil_fail = gpu::StencilOp::zero,
             .on_pass = gpu::StencilOp::zero,
             .reference = static_cast<std::uint8_t>(-batch.start)}); // counts wrap
        frame.state(state);
        frame.draw_fullscreen(*mask_);
        frame.counters().mask_fragments += pixels(batch.area);
    }

    LightView light_;
    Remedies remedies_;
    VolumeCasters casters_;
    std::vector<std::int32_t> base_vertices_; ///< of each caster, in the geometry pool
    std::vector<ReceiverBits> bits_;          ///< of each pass
    gpu::Buffer indices_;
    gpu::Buffer instances_;
    gpu::VertexArray vertices_;
    const gpu::Buffer* positions_ = nullptr;
    const gpu::Program* count_ = nullptr;
    const gpu::Program* mask_ = nullptr;
};

class Volume final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "volume", "stencil shadow volumes: hard edges, exact on everything"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        return predict_volume(pair, casters);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<VolumeJob>();
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_volume() {
    return std::make_unique<Volume>();
}

} // namespace shadows
