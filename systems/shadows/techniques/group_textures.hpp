// The shadow textures of one group of casters: one from a light without a size, one from each of
// some points of a light with a size.

#pragma once

#include "engine/render/light_visibility.hpp"
#include "systems/shadows/techniques/caster_texture.hpp"
#include "systems/shadows/techniques/receiver_bits.hpp"
#include "systems/shadows/volumes/swept_bounds.hpp"

#include <vector>

namespace shadows {

class GroupTextures {
public:
    /// Fits the textures to a group.
    /// @param plans those that name the group, at least one
    /// @param points of the light, each without a size
    /// Errors: as fit_texture() has them.
    engine::Result<void> update(
        const ShadowRequest& request,
        const CasterGroup& casters,
        const std::vector<const Plan*>& plans,
        const std::vector<LightView>& points,
        int size);

    /// Draws those that have to be.
    engine::Result<void> render(
        gpu::Frame& frame,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry,
        TextureSamples& samples);

    [[nodiscard]] bool is_soft() const { return textures_.size() > 1; }
    /// Where the mask may change: one rectangle round all receivers, or one for each where that is
    /// less to draw.
    [[nodiscard]] std::vector<gpu::Rect>
    areas(const scene::CameraView& camera, const gpu::Rect& whole) const;
    /// Looks into one of the textures. @pre a pass on the mask, or on a sum where they are soft, is
    /// open, and the G-buffer is bound
    void look_up(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        std::size_t point,
        std::span<const gpu::Rect> areas,
        const gpu::RenderState& state) const;

    [[nodiscard]] int size() const { return textures_.empty() ? 0 : textures_.front().size(); }
    /// From one of the light's points. @pre update() was called
    [[nodiscard]] const TextureView& view() const { return textures_.front().view(); }
    [[nodiscard]] std::size_t gpu_bytes() const;

private:
    std::vector<CasterTexture> textures_; ///< by point of the light
    Remedies remedies_;
    ReceiverBits receivers_;
    std::vector<SweptReach> reaches_; ///< where shadows can fall
    const gpu::Program* mask_ = nullptr;
};

} // namespace shadows
