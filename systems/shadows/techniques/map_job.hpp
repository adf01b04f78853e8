// A shadow map at work: layers drawn from a light, and the mask pass that looks into them. What the
// three kinds of maps have in common; how their layers lie is for each to say.

#pragma once

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/render/draw_runs.hpp"
#include "engine/render/geometry.hpp"
#include "systems/shadows/maps/map_error.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/receiver_bits.hpp"

#include <string>
#include <vector>

namespace shadows {

class MapJob : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override;
    engine::Result<void> render(
        gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) override;
    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override;
    [[nodiscard]] bool may_wait() const override { return true; }
    [[nodiscard]] std::size_t gpu_bytes() const override { return map_.size_bytes(); }

protected:
    explicit MapJob(std::string_view technique) : technique_(technique) {}

    /// Lays the layers. @param size texels per side
    virtual void fit(const ShadowRequest& request, int size) = 0;
    [[nodiscard]] virtual int layers() const = 0;
    [[nodiscard]] virtual glm::dmat4 map_from_world(int layer) const = 0;
    /// Whether a caster can darken anything that the layer holds.
    [[nodiscard]] virtual bool reaches(int layer, const engine::WorldAabb& caster) const = 0;
    /// Texel of a map with a single texel per side at the pair's receiver, metres.
    [[nodiscard]] virtual double texel_m_of_one(const PairView& pair) const = 0;
    /// What map_mask.frag is compiled for, besides the filter.
    [[nodiscard]] virtual gpu::Defines mask_defines() const = 0;
    /// The uniforms of map_mask.vert that depend on the kind.
    virtual void place(const gpu::Program& mask, const scene::CameraView& camera) const = 0;

    [[nodiscard]] const LightView& light() const { return light_; }
    /// Bounds of what the layers draw, a box per group.
    [[nodiscard]] std::span<const engine::WorldAabb> caster_bounds() const { return bounds_; }
    [[nodiscard]] MapFilter filter() const { return filter_; }
    [[nodiscard]] const Remedies& remedies() const { return remedies_; }

private:
    /// Everything that one layer draws with.
    struct Layer {
        gpu::Framebuffer target;
        std::unique_ptr<render::DrawRuns> draws;
    };

    /// What the most demanding plan needs: a filter and texels per side.
    engine::Result<void> choose(const ShadowRequest& request);
    void add_soft_defines(gpu::Defines& defines) const;
    engine::Result<void> resize();
    engine::Result<void> render_layer(
        gpu::Frame& frame,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry,
        int layer);

    std::string technique_;
    LightView light_;
    Remedies remedies_;
    MapFilter filter_ = MapFilter::bilinear;
    bool serves_all_ = false;
    int soft_taps_ = kSoftTaps;
    int size_ = 0;
    std::vector<std::uint32_t> casters_; ///< ids, rising
    std::vector<engine::WorldAabb> bounds_;
    engine::WorldAabb served_; ///< bounds of the receivers
    scene::CameraView camera_; ///< of the last update; casters are culled by it only with
                               ///< map_swept_casters off
    ReceiverBits receivers_;
    gpu::Texture map_;
    std::vector<Layer> layers_;
    const gpu::Program* mask_ = nullptr;
};

/// Indices of the groups that the plans give to a technique, rising.
std::vector<std::uint32_t> groups_of(const ShadowRequest& request, std::string_view technique);

} // namespace shadows
